#!/bin/sh
# make_files.sh MAKE_ROM DEADPOINT CASE FOLDER: the files that the tests of the Python package read.
set -eu
rm -rf "$4"
mkdir -p "$4"
"$1" "$3" "$4/press.rom"
cp "$3" "$4/case.toml"
cd "$4"
"$2" run -q case.toml --reduced press.rom -o reduced >/dev/null
"$2" run -q case.toml --size 4 --set 'operation.0.duration=20 min' --set 'output.field_times=["10 min", "20 min"]' -o full >/dev/null
