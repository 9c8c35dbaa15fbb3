"""What the teacher is told of hand-ins that cannot be used, and how names are sorted and set in columns."""

import pytest
from nbformat.v4 import new_notebook

from dev.teaching.fresh_copy import Sheet
from dev.teaching.grading import columns, report, source, table, write
from dev.teaching.hand_ins import NOTHING, letters, plan
from tests.dev.answers import ASKED, LESSON, answered, release, save


def useless(name, why):
    return f"Handed in, not usable: {name} {why}. It was not used."


@pytest.fixture
def four(tmp_path):
    """The jobs and sentences of four learners who handed in little that can be used."""
    sheets = [Sheet(number, save(release(number), tmp_path, f"{number}.ipynb"), LESSON[number]) for number in ASKED]
    folder = tmp_path / "answers"
    save(answered("04"), folder, "sam/04-answers.ipynb")
    (folder / "sam" / "answers.pdf").touch()
    save(new_notebook(), folder, "tom/04-answers.ipynb")
    save(release("08"), folder, "uma/answers.ipynb")
    (folder / "vic").mkdir()
    return plan(sheets, folder)


def test_every_file_that_is_not_used_has_its_sentence(four):
    jobs, said = four
    told = {(job.learner, job.sheet.number): job.trouble for job in jobs}
    assert told == {
        ("sam", "04"): "",
        ("sam", "05"): useless("sam/answers.pdf", "is no notebook"),
        ("tom", "04"): useless("tom/04-answers.ipynb", "has no cells"),
        ("tom", "05"): NOTHING,
        ("uma", "04"): useless("uma/answers.ipynb", "has exercises of another lesson"),
        ("uma", "05"): useless("uma/answers.ipynb", "has exercises of another lesson"),
        ("vic", "04"): NOTHING,
        ("vic", "05"): NOTHING,
    }
    assert said == [
        "sam: sam/answers.pdf is no notebook. It was not used.",
        "tom: tom/04-answers.ipynb has no cells. It was not used.",
        "uma: uma/answers.ipynb has exercises of another lesson. It was not used.",
    ]


def test_the_tables_and_the_report_tell_useless_from_nothing(four, tmp_path):
    jobs, said = four
    rows = [
        dict(learner=job.learner, lesson=job.sheet.number, exercise="a", points=0, said=job.trouble, file=source(job))
        for job in jobs
    ]
    points, answers = write(rows, tmp_path)
    assert '\ntom,0,0,0,"tom/04-answers.ipynb (handed in, not usable)",\n' in points.read_text()
    assert "sam/answers.pdf (handed in, not usable)" in answers.read_text()
    later, _ = write([row | {"lesson": "06"} for row in rows if row["lesson"] == "05"], tmp_path)
    assert points.name == "points-04-05.csv" and later.name == "points-06.csv", "the next assignment leaves them alone"
    assert "05 handed in, not usable: sam/answers.pdf\n" in table(rows, jobs)
    lines = report(jobs, said).splitlines()
    assert lines[1] == "- Nothing was handed in by tom (lesson 05), vic (lesson 04, 05)."
    assert lines[2] == "- Handed in, not usable, by sam (lesson 05), tom (lesson 04), uma (lesson 04, 05)."


def test_names_are_in_the_order_of_their_letters_and_the_columns_straight():
    names = ["Ørsted", "zoe", "adam", "Zoë", "Zoe\u0308", "Adam", "李雷", "Émile", "Zz", "eva"]
    in_order = sorted(names, key=letters)
    assert in_order[:4] == ["Adam", "adam", "Émile", "eva"] and in_order.index("Zz") > in_order.index("Zoë")
    rows = [dict(learner=name, lesson="04", exercise="a", points=1, said="", file="") for name in in_order]
    lines = table(rows, []).splitlines()[: len(names) + 1]
    assert len({columns(line) for line in lines[1:]}) == 1 and columns("李雷") == 4 and columns("Zoe\u0308") == 3
