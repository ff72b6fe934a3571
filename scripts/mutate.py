#!/usr/bin/env python3
"""Changes signs, factors and comparisons, one at a time, and lists the changes that no test notices.

    scripts/mutate.py [COUNT [FOLDER...]]    COUNT changes (default 120), as many from each folder, drawn at random but always the same ones

Folders: those of `tests` below, all of src/deadpoint, app and python/bindings together. Works on copies in build/mutate, WORKERS of them
(default 2) at a time; a change counts as caught when the folder's own tests, or those of the folders that build on it, fail. Writes
docs/validation/mutation.md; what is said there about survivors below "Looked at" is kept.
"""
import concurrent.futures
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
import threading
import time

root = pathlib.Path(__file__).resolve().parent.parent
workplace = root / "build/mutate"
# The tests of a folder: its own, and behind the bar those of what uses it. A name is that of ctest.
tests = {
    "core": "unit_core | unit_casefile bad_cases unit_press unit_full",
    "io": "unit_io | unit_report unit_press unit_full faults",
    "exchange": "unit_exchange | unit_press unit_full unit_fem",
    "casefile/describe": "unit_casefile | bad_cases unit_press unit_full",
    "casefile/check": "unit_casefile | bad_cases unit_press unit_full",
    "casefile/files": "unit_casefile | bad_cases unit_press unit_full unit_learn",
    "casefile/reference": "unit_casefile | cli",
    "casefile/studies": "unit_casefile | bad_cases unit_press unit_full unit_learn",
    "casefile/syntax": "unit_casefile | bad_cases unit_press unit_full",
    "mechanism": "unit_mechanism | unit_press unit_full",
    "crankshaft": "unit_crankshaft | unit_press unit_full",
    "tribology": "unit_tribology | unit_press unit_full paper",
    "surroundings": "unit_surroundings | unit_press unit_full paper",
    "machine/assembly": "unit_machine | unit_press unit_full drawings verification_heat",
    "machine/cad": "unit_machine | unit_press unit_full drawings",
    "machine/foreign": "unit_machine | unit_press unit_full drawings",
    "machine/geometry": "unit_machine | unit_press unit_full verification_heat",
    "machine/parts": "unit_machine | unit_press unit_full verification_heat",
    "heat": "unit_heat | unit_reduce unit_fem verification_heat",
    "reduce/causes": "unit_reduce | unit_fem unit_press unit_full",
    "reduce/certificate": "unit_reduce | unit_fem unit_press unit_full",
    "reduce/dense": "unit_reduce | unit_fem unit_learn",
    "reduce/offline": "unit_reduce | unit_fem unit_learn",
    "reduce/online": "unit_reduce | unit_fem unit_learn",
    "reduce/sensitivity": "unit_reduce | unit_learn",
    "fem/algebra": "unit_fem | verification_elastic verification_heat",
    "fem/conduction": "unit_fem | verification_heat",
    "fem/elastic": "unit_fem | verification_elastic",
    "fem/estimate": "unit_fem | verification_heat verification_elastic",
    "fem/reduction": "unit_fem | unit_learn unit_press unit_full",
    "fem/reference": "unit_fem | verification_heat verification_elastic",
    "fem/space": "unit_fem | verification_heat verification_elastic",
    "fem/transfer": "unit_fem | verification_elastic",
    "drift": "unit_drift | unit_press unit_full verification_elastic",
    "calibration": "unit_calibration | unit_learn",
    "design": "unit_design | unit_learn",
    "press/check": "unit_press | bad_cases cli",
    "press/compare": "unit_press | cli",
    "press/drift": "unit_press | verification_elastic unit_learn",
    "press/laws": "unit_press | unit_learn paper",
    "press/loads": "unit_press | unit_learn paper",
    "press/machine": "unit_press | verification_heat",
    "press/problem": "unit_press | unit_learn verification_heat",
    "press/run": "unit_press | unit_report cli",
    "press/translate": "unit_press | verification_heat",
    "twin/calibrate": "unit_twin unit_learn | cli",
    "twin/explore": "unit_twin unit_learn | unit_press unit_full cli",
    "twin/map": "unit_twin | cli",
    "twin/model": "unit_twin unit_learn | unit_press unit_full cli",
    "twin/run": "unit_twin unit_learn | unit_press unit_full cli",
    "full/draft": "unit_full | cli",
    "full/fields": "unit_full | verification_elastic cli",
    "full/frame": "unit_full | verification_elastic cli",
    "full/model": "unit_full | cli",
    "full/refine": "unit_full | cli",
    "full/run": "unit_full | unit_learn cli",
    "full/sweep": "unit_full | cli",
    "report": "unit_report | cli page",
    "api": "unit_api | install_and_link",
    "app": "cli | faults",
    "bindings": "python_reduced | python_results python_field",
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


def source_folder(folder):
    return root / {"app": "app", "bindings": "python/bindings"}.get(folder, f"src/deadpoint/{folder}")


def candidates(folder):
    for file in sorted(source_folder(folder).rglob("*.cpp")):
        for number, line in enumerate(file.read_text().splitlines()):
            code = line.split("//")[0]
            if not code.strip() or code.lstrip().startswith("#") or '"' in code or "throw" in code or "template" in code:
                continue
            for pattern, to, name in changes:
                for match in pattern.finditer(code):
                    changed = code[: match.start()] + match.expand(to) + code[match.end():]
                    yield folder, file.relative_to(root), number, line, changed, name


def targets_of(test):
    """What has to be built for a test of ctest."""
    if test.startswith("python"):
        return ["deadpoint", "deadpoint_reduced_module", "deadpoint_field_module"]
    if test in ("cli", "faults", "page", "drawings", "install_and_link"):
        return ["all"]
    return [f"test_{test}"]


class Workplace:
    """A copy of the sources with a build of its own, in which one change at a time is tried."""

    def __init__(self, number):
        self.tree = workplace / f"tree-{number}"
        self.build = self.tree / "build/ci"
        self.seconds = {}  # of each test before anything is changed

    def prepare(self):
        if self.tree.exists():
            shutil.rmtree(self.tree)
        shutil.copytree(root, self.tree, ignore=shutil.ignore_patterns("build", ".git", "results"))
        # Each source by itself: a change then compiles one, and what is not changed comes from the compiler's cache.
        subprocess.run(["cmake", "--preset", "ci", "-S", self.tree, "-B", self.build, "-DDEADPOINT_UNITY=OFF",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"], check=True, stdout=subprocess.DEVNULL)

    def builds(self, test):
        return subprocess.run(["ninja", "-C", self.build, "-j1", *targets_of(test)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode == 0

    def passes(self, test, limit):
        """Whether it passes within `limit` seconds and 8 GiB."""
        def limits():
            resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))

        began = time.monotonic()
        passes = subprocess.run(["ctest", "--preset", "ci", "--test-dir", self.build, "-R", f"^{test}$", "--timeout", str(limit)],
                                cwd=self.tree, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                preexec_fn=limits).returncode == 0
        return passes, time.monotonic() - began

    def time_of_sound(self, test):
        if test not in self.seconds:
            passes, self.seconds[test] = self.passes(test, 1800) if self.builds(test) else (False, 0)
            if not passes:
                sys.exit(f"error: {test} fails before anything is changed")
        return self.seconds[test]

    def fate(self, entry, names):
        """What becomes of a change by these tests."""
        _, file, number, _, changed, _ = entry
        path = self.tree / file
        original = path.read_text()
        lines = original.splitlines()
        lines[number] = changed
        for test in names:
            sound = self.time_of_sound(test)
            path.write_text("\n".join(lines) + "\n")
            try:
                if not self.builds(test):
                    return "does not compile"
                if not self.passes(test, 30 + int(5 * sound))[0]:  # a loop may have lost its end
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
        f"{len(done)} changes of a sign, factor, constant or comparison drawn at random from each folder, on",
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
    if "--help" in sys.argv:
        print(__doc__)
        return
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 120
    folders = sys.argv[2:] or list(tests)
    drawn = []
    for folder in folders:
        every = list(candidates(folder))
        drawn.append(random.Random(folder).sample(every, len(every)))
    chosen = iter([entry for turn in itertools.zip_longest(*drawn) for entry in turn if entry])
    done = []
    lock = threading.Lock()

    def next_entry():
        with lock:
            return next(chosen, None) if len(done) < count else None

    def work(place):
        """All tests of a folder in turn: those of others take long to build, and only survivors of its own need them."""
        place.prepare()
        while entry := next_entry():
            own, others = (part.split() for part in tests[entry[0]].split("|"))
            what = place.fate(entry, own + others)
            with lock:
                if what != "does not compile" and len(done) < count:
                    done.append((*entry, what))
                    print(f"{len(done)}/{count} {what}: {entry[1]}:{entry[2] + 1} {entry[5]}", flush=True)
                    report(done)

    places = [Workplace(number) for number in range(int(os.environ.get("WORKERS", "2")))]
    with concurrent.futures.ThreadPoolExecutor(len(places)) as pool:
        for finished in [pool.submit(work, place) for place in places]:
            finished.result()
    print(f"{sum(1 for *_, what in done if what == 'caught')} of {len(done)} caught")


if __name__ == "__main__":
    main()
