"""Grade what a class handed in, with nbgrader: the course in a folder, and the tables of what came out."""

import csv
import os
import re
import shutil
import sys
import unicodedata
from collections import Counter
from pathlib import Path

import nbformat

from dev.teaching.fresh_copy import Sheet, fresh_copy, mark
from dev.teaching.hand_ins import NOTHING, UNUSABLE, plan

STOPPED = "The cell stopped"
CONFIG = """# `nbgrader` reads this file when it is called in this folder.
c = get_config()
c.CourseDirectory.course_id = "kalman"
c.ClearSolutions.code_stub = {{"python": ""}}
c.Execute.timeout = {seconds}
c.Execute.error_on_timeout = {{"ename": "TimeoutError", "evalue": "longer than {seconds} s", "traceback": []}}
c.KernelManager.transport_encryption = "required"  # whoever has an account could listen to what is graded
"""
OTHER_FILES = """{folder} holds points of an assignment whose files have other names, as older versions of the course
made them. What was handed out from it can still be graded there. For a new assignment move that folder away, or name
another one with --out."""


class Course:
    """An nbgrader course in a folder, with one assignment of some lessons."""

    def __init__(self, folder, lessons, seconds=None):
        self.folder, self.lessons, self.seconds = Path(folder).resolve(), lessons, seconds
        self.name = "lessons-" + "-".join(path.name[:2] for path in lessons)

    def lock(self):
        """Keep all others of this machine out of the folder."""
        self.folder.mkdir(parents=True, exist_ok=True)
        self.folder.chmod(0o700)

    def build(self, make):
        """Write the teacher's version, make(lesson) for each lesson, and from it the learners'."""
        self.lock()
        if any(self.release(path).name == path.name for path in self.lessons) and self.is_graded():
            sys.exit(OTHER_FILES.format(folder=os.path.relpath(self.folder)))
        shutil.rmtree(self.folder / "source" / self.name, ignore_errors=True)
        (self.folder / "source" / self.name).mkdir(parents=True)
        config = CONFIG.format(seconds=self.seconds or 60)
        (self.folder / "nbgrader_config.py").write_text(config, encoding="utf-8")
        for path in self.lessons:
            nbformat.write(make(path), self.folder / "source" / self.name / f"{path.name[:2]}-answers.ipynb")
        done = self.api().generate_assignment(self.name, force=True)
        if not done["success"]:
            raise RuntimeError(done["log"])

    def api(self):
        from nbgrader.apps.api import NbGraderAPI
        from nbgrader.preprocessors import Execute
        from traitlets.config import PyFileConfigLoader

        beside = str(Path(sys.executable).parent)  # nbgrader calls `alembic`, which lies there
        if beside not in os.environ["PATH"].split(os.pathsep):
            os.environ["PATH"] = os.pathsep.join([beside, os.environ["PATH"]])
        config = PyFileConfigLoader("nbgrader_config.py", path=str(self.folder)).load_config()
        config.CourseDirectory.root = str(self.folder)
        config.NbGraderAPI.log_level = "ERROR"
        self.seconds = config.Execute.timeout = self.seconds or config.Execute.get("timeout", 60)
        Execute.extra_arguments.tag(config=True)
        config.Execute.extra_arguments = ["--log-level=ERROR"]  # of the kernels
        return NbGraderAPI(config=config)

    def release(self, lesson):
        """The notebook for the learners. Before it had a name of its own, it had the lesson's."""
        old = self.folder / "release" / self.name / lesson.name
        return old if old.exists() else old.with_name(f"{lesson.name[:2]}-answers.ipynb")

    def is_graded(self):
        return any((self.folder / "submitted").glob(f"*/{self.name}"))

    def sheets(self):
        return [Sheet(lesson.name[:2], self.release(lesson), lesson) for lesson in self.lessons]

    def grade(self, answers):
        """Grade a folder of answers. (rows, jobs, sentences about files); a row for each learner and exercise."""
        self.lock()  # also one that was made before there was this line
        os.environ.pop("KFLEARN_PROGRESS", None)  # the teacher's own progress stays as it is
        jobs, said = plan(self.sheets(), answers)
        if not jobs:
            return [], jobs, said
        rows, api, done = [], self.api(), 0
        number = sum(job.attempt is not None for job in jobs)
        learners = len({job.learner for job in jobs})
        print(f"Notebooks: {number}. Learners: {learners}. A cell may run for {self.seconds} s: an endless loop takes")
        print("as long before it is stopped. Then the notebook goes on.", flush=True)
        for job in jobs:
            missing = []
            if job.attempt:
                done += 1
                where = f"{job.learner}, lesson {job.sheet.number}: {job.attempt.file.name}"
                print(f"[{done}/{number}] {where} …", flush=True)
                missing = self.run(api, job)
            rows += self.rows(api, job, missing)
        return rows, jobs, said

    def notebook(self, job):
        """nbgrader's name of a job's notebook."""
        return next(self.release(each).stem for each in self.lessons if each.name[:2] == job.sheet.number)

    def run(self, api, job):
        """Let nbgrader grade a fresh copy with the learner's answers. The exercises without an answer cell."""
        copy, missing = fresh_copy(job.sheet, job.attempt.file.cells, job.attempt.kind)
        place = self.folder / "submitted" / student(job.learner) / self.name / f"{self.notebook(job)}.ipynb"
        place.parent.mkdir(parents=True, exist_ok=True)
        nbformat.write(copy, place)
        api.coursedir.notebook_id = self.notebook(job)
        done = api.autograde(self.name, student(job.learner))
        job.trouble = "" if done["success"] else reason(done.get("log", "") + done.get("error", ""))
        return missing

    def rows(self, api, job, missing):
        """The rows of a learner's notebook. Points are what nbgrader has in its gradebook."""
        points, said, learner = {}, {}, student(job.learner)
        if not job.trouble:
            with api.gradebook as book:
                graded = book.find_submission_notebook(self.notebook(job), self.name, learner).grades
                points = {grade.name: round(grade.score) for grade in graded}
            file = self.folder / "autograded" / learner / self.name / f"{self.notebook(job)}.ipynb"
            cells = nbformat.read(file, as_version=4).cells
            said = {mark(cell): sentence(cell.get("outputs", [])) for cell in cells}
        return [
            {
                "learner": job.learner,
                "lesson": job.sheet.number,
                "exercise": name.removeprefix("points-"),
                "points": points.get(name, 0),
                "said": job.trouble or told(job.sheet, name, points.get(name, 0), said, missing),
                "file": source(job),
            }
            for name in job.sheet.graded
        ]


def source(job):
    """For the tables: the file that was graded, or those that could not be."""
    note = UNUSABLE.lower() if job.unusable else job.note
    return f"{job.files} ({note})" if job.files and note else job.files


def student(learner):
    """The learner's name as nbgrader bears it: it takes some signs for patterns of file names."""
    return re.sub(r"[\[\]*?\\]", "-", learner)


def told(sheet, name, points, said, missing):
    """What a learner is told of an exercise: what the check said, or why there was nothing to check."""
    exercise, check = name.removeprefix("points-"), said.get(name, "")
    variable = sheet.variables.get(exercise)
    if points:
        return check
    if exercise in missing:
        return f"No answer cell was found: nothing in the notebook makes the name {variable}."
    if said.get(exercise, "").startswith(STOPPED):
        return said[exercise]
    if f"NameError: name '{variable}' is not defined" in check:
        return f"{check}. The check looks for the name {variable}: was it renamed?"
    return check


def sentence(outputs):
    """What a cell said, or the error with which it stopped."""
    for output in outputs:
        if output.output_type == "error":
            if output.ename in ("KeyboardInterrupt", "TimeoutError"):
                return f"{STOPPED} at the time limit."
            why = re.sub(r"\(\d+\.py, line", "(line", output.evalue)  # IPython's names for cells say nothing
            name = output.ename.replace("_IncompleteInputError", "SyntaxError")  # Python 3.14's own kind of it
            return f"{STOPPED} with {name}: {why}".rstrip(": ")
    return " ".join(output.text.strip() for output in outputs if output.output_type == "stream")


def reason(log):
    """One sentence from nbgrader's log about a notebook that could not be graded."""
    if "DeadKernelError" in log or "Kernel died" in log:
        return "Not graded: the notebook ended its kernel."
    if "UnresponsiveKernel" in log:
        return "Not graded: the notebook ran on and could not be interrupted."
    found = re.search(r"(\w+Error|\w+Exception): .*", re.sub(r"\x1b\[[\d;]*m", "", log))
    return f"Not graded: {found[0] if found else 'nbgrader failed'}"


# ---- the tables


def columns(text):
    """How wide a text is on the screen: a Chinese sign takes two columns, an accent of its own none."""
    return sum(
        0 if unicodedata.combining(sign) else 2 if unicodedata.east_asian_width(sign) in "WF" else 1 for sign in text
    )


def table(rows, jobs):
    """The printed table: a line for each learner, then one for each exercise with what was said most often."""
    asked = list(dict.fromkeys((row["lesson"], row["exercise"]) for row in rows))
    short = {each: f"{each[0]}.{[e for e in asked if e[0] == each[0]].index(each) + 1}" for each in asked}
    points = {(row["learner"], row["lesson"], row["exercise"]): row["points"] for row in rows}
    learners = list(dict.fromkeys(row["learner"] for row in rows))
    width = max(map(columns, ["learner", *learners]))
    lines = [" ".join(["learner" + " " * (width - 7), *(f"{short[each]:>5}" for each in asked), "    sum"])]
    for learner in learners:
        got = [points[learner, *each] for each in asked]
        line = " ".join(
            [learner + " " * (width - columns(learner)), *(f"{one:5g}" for one in got), f"{sum(got):4g}/{len(got)}"]
        )
        notes = [f"{job.sheet.number} {job.note}" for job in jobs if job.learner == learner and job.note]
        lines.append(f"{line}   {'; '.join(notes)}".rstrip())
    lines.append("")
    for each in asked:
        mine = [row for row in rows if (row["lesson"], row["exercise"]) == each]
        right = sum(row["points"] for row in mine)
        lines.append(f"{short[each]} {each[1]}: {right} of {len(mine)} right")
        for said, number in Counter(row["said"] for row in mine if not row["points"]).most_common(2):
            lines.append(f"      {number} × {said}")
    return "\n".join(lines)


def report(jobs, said):
    """What was done with the files, and who handed in nothing, or nothing usable: a sentence a line."""
    number = sum(not job.trouble for job in jobs)
    from_lesson = sum(job.note == "from the lesson itself" for job in jobs)
    lines = [f"What was done: {number} graded, of these from the lesson itself: {from_lesson}."]
    for begins, kind in (
        ("Nothing was handed in by", [job for job in jobs if job.trouble == NOTHING]),
        (f"{UNUSABLE}, by", [job for job in jobs if job.unusable]),
    ):
        numbers = {}
        for job in kind:
            numbers.setdefault(job.learner, []).append(job.sheet.number)
        if who := [f"{learner} (lesson {', '.join(each)})" for learner, each in numbers.items()]:
            lines.append(f"- {begins} {', '.join(who)}.")
    for job in jobs:
        if job.attempt and job.trouble:
            lines.append(f"- {job.learner}, lesson {job.sheet.number}: {job.attempt.file.name}. {job.trouble}")
    return "\n".join([*lines, *(f"- {line}" for line in said)])


def write(rows, folder):
    """points-04-05.csv, a line for each learner; answers-04-05.csv, a line for each answer. Returns the two paths."""
    asked = list(dict.fromkeys((row["lesson"], row["exercise"]) for row in rows))
    points = {(row["learner"], row["lesson"], row["exercise"]): row["points"] for row in rows}
    files = {(row["learner"], row["lesson"]): row["file"] for row in rows}
    lessons = list(dict.fromkeys(lesson for lesson, _ in asked))
    tables = [folder / f"{kind}-{'-'.join(lessons)}.csv" for kind in ("points", "answers")]
    with open(tables[0], "w", newline="", encoding="utf-8") as file:
        sheet = csv.writer(file)
        names = [f"{lesson} {name}" for lesson, name in asked]
        sheet.writerow(["learner", *names, "sum", *(f"{lesson} file" for lesson in lessons)])
        for learner in dict.fromkeys(row["learner"] for row in rows):
            got = [points[learner, *each] for each in asked]
            sheet.writerow([learner, *got, sum(got), *(files[learner, lesson] for lesson in lessons)])
    with open(tables[1], "w", newline="", encoding="utf-8") as file:
        sheet = csv.DictWriter(file, ["learner", "lesson", "exercise", "points", "said", "file"])
        sheet.writeheader()
        sheet.writerows(rows)
    return tables
