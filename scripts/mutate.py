#!/usr/bin/env python3
"""Changes signs, factors and comparisons in the physics, one at a time, and lists the changes that no test notices.

    scripts/mutate.py [COUNT [FOLDER...]]    COUNT changes (default 60), as many from each folder, drawn at random but always the same ones

Folders: mechanism, crankshaft, tribology, surroundings, drift. Works on a copy in build/mutate; a change counts as caught when
the folder's unit tests, or the tests of the folders that build on it, fail. Writes docs/validation/mutation.md; what is said
there about survivors below "Looked at" is kept. JOBS sets how many compilers run at a time.
"""
import datetime
import itertools
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent
copy = root / "build/mutate/tree"
build = copy / "build/mutate"
jobs = os.environ.get("JOBS", str(os.cpu_count()))
# The tests of a folder: its own, and those of what uses it without solving fields.
tests = {
    "mechanism": ["test_unit_mechanism", "test_unit_study"],
    "crankshaft": ["test_unit_crankshaft", "test_unit_study"],
    "tribology": ["test_unit_tribology", "test_unit_study", "test_paper"],
    "surroundings": ["test_unit_surroundings", "test_unit_study", "test_paper"],
    "drift": ["test_unit_drift", "test_unit_study", "test_verification_elastic"],
}
looked_at = "\n## Looked at\n"
changes = [
    (re.compile(r"(?<=[\w)\]]) \+ (?=[\w(])"), " - ", "plus to minus"),
    (re.compile(r"(?<=[\w)\]]) - (?=[\w(])"), " + ", "minus to plus"),
    (re.compile(r"(?<=[\w)\]]) \* (?=[\w(])"), " / ", "times to over"),
    (re.compile(r"(?<=[\w)\]]) / (?=[\w(])"), " * ", "over to times"),
    (re.compile(r"(?<=return )-(?=[\w(])"), "", "sign dropped"),
    (re.compile(r" \+= "), " -= ", "add to subtract"),
    (re.compile(r"(?<=[\w)\]]) < (?=[\w(])"), " >= ", "comparison turned"),
    (re.compile(r"(?<![\w.])(0\.\d*[1-9]\d*|[1-9]\.\d+)(?![\w.])"), r"(1.5 * \1)", "constant times 1.5"),
]


def candidates(folder):
    for file in sorted((root / "src/deadpoint" / folder).rglob("*.cpp")):
        for number, line in enumerate(file.read_text().splitlines()):
            code = line.split("//")[0]
            if not code.strip() or code.lstrip().startswith("#") or '"' in code or "throw" in code or "template" in code:
                continue
            for pattern, to, name in changes:
                for match in pattern.finditer(code):
                    changed = code[: match.start()] + match.expand(to) + code[match.end():]
                    yield folder, file.relative_to(root), number, line, changed, name


def build_test(name):
    return subprocess.run(["ninja", "-C", build, "-j", jobs, name], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0


def run_test(name, limit):
    """Whether it passes, and the seconds of the processor it took; it may have `limit` of them, and 8 GiB."""
    def limits():
        resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))

    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    program = next(build.glob(f"tests/**/{name}"))
    passes = subprocess.run([program], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                            preexec_fn=limits).returncode == 0
    return passes, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def time_of_sound(name):
    """Seconds of a test before anything is changed."""
    passes, seconds = run_test(name, 900) if build_test(name) else (False, 0)
    if not passes:
        sys.exit(f"error: {name} fails before anything is changed")
    return seconds


def prepare():
    if copy.exists():
        shutil.rmtree(copy)
    shutil.copytree(root, copy, ignore=shutil.ignore_patterns("build", ".git", "results"))
    # Each source by itself: a change then compiles one, and what is not changed comes from the compiler's cache.
    os.environ["CCACHE_BASEDIR"] = str(copy)
    subprocess.run(["cmake", "--preset", "ci", "-S", copy, "-B", build, "-DDEADPOINT_UNITY=OFF"], check=True, stdout=subprocess.DEVNULL)


def fate(entry, names, sound):
    """What becomes of a change by these tests."""
    _, file, number, _, changed, _ = entry
    path = copy / file
    original = path.read_text()
    lines = original.splitlines()
    lines[number] = changed
    for test in names:
        if test not in sound:
            sound[test] = time_of_sound(test)
        path.write_text("\n".join(lines) + "\n")
        try:
            if not build_test(test):
                return "does not compile"
            if not run_test(test, 30 + int(10 * sound[test]))[0]:  # a loop may have lost its end
                return "caught"
        finally:
            path.write_text(original)
    return "survived"


def report(done):
    caught = sum(1 for *_, what in done if what == "caught")
    survivors = [entry for entry in done if entry[-1] == "survived"]
    lines = [
        "<!-- Written by scripts/mutate.py, but for what stands below \"Looked at\". -->",
        "# Changes that the tests must notice",
        "",
        f"{len(done)} changes of a sign, factor, constant or comparison in the physics folders, drawn at random from each, on",
        f"{datetime.date.today().isoformat()}: {caught} caught, {len(survivors)} not.",
        "",
        "| folder | changes | caught |",
        "|---|--:|--:|",
    ]
    for folder in tests:
        of_folder = [entry for entry in done if entry[0] == folder]
        if of_folder:
            lines.append(f"| {folder} | {len(of_folder)} | {sum(1 for *_, what in of_folder if what == 'caught')} |")
    if survivors:
        lines += ["", "Not noticed:", "", "| place | line | change |", "|---|---|---|"]
        for _, file, number, line, _, name, _ in survivors:
            lines.append(f"| {file}:{number + 1} | `{line.strip().replace('|', '&#124;')}` | {name} |")
    page = root / "docs/validation/mutation.md"
    said = page.read_text().partition(looked_at)[2] if page.exists() else ""
    page.write_text("\n".join(lines) + "\n" + (looked_at + said if said else ""))


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    folders = sys.argv[2:] or list(tests)
    drawn = []
    for folder in folders:
        every = list(candidates(folder))
        drawn.append(random.Random(folder).sample(every, len(every)))
    chosen = [entry for turn in itertools.zip_longest(*drawn) for entry in turn if entry]
    prepare()
    done = []
    sound = {}
    # First all by the folder's own tests; those of other folders take long to build, and only survivors need them.
    for entry in chosen:
        if len(done) == count:
            break
        what = fate(entry, tests[entry[0]][:1], sound)
        if what != "does not compile":
            done.append((*entry, what))
            print(f"{len(done)}/{count} {what}: {entry[1]}:{entry[2] + 1} {entry[5]}", flush=True)
            report(done)
    for i, (*entry, what) in enumerate(done):
        if what == "survived":
            done[i] = (*entry, fate(entry, tests[entry[0]][1:], sound))
            print(f"again, {done[i][-1]}: {entry[1]}:{entry[2] + 1} {entry[5]}", flush=True)
            report(done)


if __name__ == "__main__":
    main()
