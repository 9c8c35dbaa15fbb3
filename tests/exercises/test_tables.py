"""The tables of wrong answers, of which several are laid together for an exercise: none hides a row of another."""

import importlib
import pkgutil

import kflearn.exercises


def modules():
    for each in pkgutil.iter_modules(kflearn.exercises.__path__):
        yield each.name, importlib.import_module(f"kflearn.exercises.{each.name}")


def exercises():
    """The sentences of each exercise, by its name."""
    public = [vars(module) for name, module in modules() if not name.startswith("_")]
    found = {name: each for module in public for name, each in module.items()}
    return {name: {row[1] for row in each.wrong.values()} for name, each in found.items() if hasattr(each, "wrong")}


def tables():
    """The rows that a module has for an exercise: module, exercise, label → sentence."""
    for home, module in modules():
        for table in vars(module).values():
            for name, rows in table.items() if isinstance(table, dict) else ():
                if isinstance(rows, dict):
                    said = {label: row[1] for label, row in rows.items() if isinstance(row, tuple) and len(row) > 1}
                    yield home, name, {label: each for label, each in said.items() if isinstance(each, str)}


def test_no_row_is_hidden_by_one_of_the_same_label():
    said, checked = exercises(), 0
    for home, name, rows in tables():
        lost = [label for label, sentence in rows.items() if sentence not in said.get(name, ())]
        if len(lost) < len(rows):  # else the table belongs to something else of the same name
            assert not lost, f"{home}: {name}"
            checked += len(rows)
    assert checked > 3000
