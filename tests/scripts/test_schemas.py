"""Holds the JSON schemas of 'deadpoint schema' against the files that are shipped, and against planted mistakes.

Run as: test_schemas.py COMMAND SOURCE. Needs python3-jsonschema and a Python with tomllib (3.11).
"""
import json
import pathlib
import subprocess
import sys
import tomllib

import jsonschema

command, source = sys.argv[1], pathlib.Path(sys.argv[2])


def validator(kind):
    text = subprocess.run([command, "schema", kind], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    jsonschema.Draft7Validator.check_schema(schema)
    return jsonschema.Draft7Validator(schema)


def kind_of(content):
    """By the keys that only one kind of file has; files that cases include are parts of cases."""
    if "sets" in content or "sweep" in content or "sensitivity" in content or "optimise" in content:
        return "study"
    if "parameters" in content and "runs" in content:
        return "calibration"
    if "source" in content and any(key in content for key in ("rises", "curves", "chain", "claims")):
        return "reference"
    return "case"


def check_shipped(validators):
    counts = dict.fromkeys(validators, 0)
    failures = []
    for file in sorted([*source.glob("cases/**/*.toml"), *source.glob("examples/**/*.toml")]):
        content = tomllib.loads(file.read_text(encoding="utf-8"))
        kind = kind_of(content)
        counts[kind] += 1
        for error in validators[kind].iter_errors(content):
            place = ".".join(str(step) for step in error.absolute_path)
            failures.append(f"{file.relative_to(source)}: {kind}: {place}: {error.message[:200]}")
    return counts, failures


def check_mistakes(case):
    """Each must be refused: otherwise the schema would hold for anything."""
    content = tomllib.loads((source / "cases/starter/case.toml").read_text(encoding="utf-8"))
    assert case.is_valid(content)
    part = next(iter(content["parts"]))
    joint = next(iter(content["joints"]))
    mistakes = {
        "misspelt section": lambda c: c.update(machin={}),
        "misspelt key": lambda c: c["parts"][part].update(materal="steel"),
        "misspelt key of a joint": lambda c: c["joints"][joint].update(frictoin={}),
        "number for a quantity": lambda c: c["operation"][0].update(speed=60),
        "no such kind of joint": lambda c: c["joints"][joint].update(kind="glued"),
        "text for true or false": lambda c: c["output"].update(fields="yes") if "output" in c else c.update(output={"fields": "yes"}),
        "two coordinates": lambda c: next(iter(c["probes"].values())).update(position=["0 mm", "1 mm"]),
        "ratio of two": lambda c: next(iter(c["materials"].values())).update(poissons_ratio=2),
    }
    missed = []
    for name, spoil in mistakes.items():
        spoilt = json.loads(json.dumps(content))
        spoil(spoilt)
        if case.is_valid(spoilt):
            missed.append(name)
    return missed


def main():
    validators = {kind: validator(kind) for kind in ("case", "study", "calibration", "reference")}
    counts, failures = check_shipped(validators)
    print(counts)
    failures += [f"not refused: {name}" for name in check_mistakes(validators["case"])]
    failures += [f"no shipped {kind} file" for kind, count in counts.items() if count == 0]
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
