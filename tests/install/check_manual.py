"""Requirement: manual page and completions name every subcommand and every option that the command's help shows."""
import pathlib
import re
import subprocess
import sys
import tempfile

program = sys.argv[1]


def help_of(*words):
    return subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout


def options_in(text):
    """All long options at the beginning of a line of the help."""
    return set(re.findall(r"^\s+(?:-\w,)?(--[a-z-]+)", text, re.MULTILINE))


def subcommands_in(text):
    return re.findall(r"^  ([a-z]+)  ", text.split("Subcommands:")[1].split("Examples:")[0], re.MULTILINE)


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([program, "--write-manual", folder], check=True)
    folder = pathlib.Path(folder)
    files = {name: (folder / name).read_text() for name in ("deadpoint.1", "deadpoint.bash", "_deadpoint", "deadpoint.fish")}
    for shell, name in (("bash", "deadpoint.bash"), ("zsh", "_deadpoint"), ("fish", "deadpoint.fish")):
        try:
            subprocess.run([shell, "-n", folder / name], check=True)
        except FileNotFoundError:
            print(f"{shell} is not here; {name} is not parsed")

subcommands = subcommands_in(help_of())
assert len(subcommands) >= 10, subcommands
missing = []
for subcommand in subcommands:
    options = options_in(help_of(subcommand))
    assert "--help" in options, subcommand
    for name, text in files.items():
        if subcommand not in text:
            missing.append(f"{name}: {subcommand}")
    section = files["deadpoint.1"].replace("\\-", "-").split(f"\\fBdeadpoint {subcommand}\\fR")[-1].split(".SS")[0]
    bash = re.search(rf"^ +{subcommand}\) words=\"(.*)\"", files["deadpoint.bash"], re.MULTILINE).group(1).split()
    zsh = files["_deadpoint"].split(f"\n    {subcommand})\n")[1].split(";;")[0]
    fish = "\n".join(line for line in files["deadpoint.fish"].splitlines() if f"_from {subcommand}'" in line)
    for option in sorted(options):
        missing += [f"deadpoint.1: {subcommand} {option}"] if not re.search(rf"{option}\b", section) else []
        missing += [f"deadpoint.bash: {subcommand} {option}"] if option not in bash else []
        missing += [f"_deadpoint: {subcommand} {option}"] if f"{option}[" not in zsh else []
        missing += [f"deadpoint.fish: {subcommand} {option}"] if not re.search(rf"-l {option[2:]}\b", fish) else []
if missing:
    sys.exit("missing:\n" + "\n".join(missing))
print(f"{len(subcommands)} subcommands, all options are there")
