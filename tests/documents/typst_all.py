"""Compiles every Typst document of a folder to PDF; says what the compiler says."""

import pathlib
import sys

import typst

bad = 0
files = sorted(pathlib.Path(sys.argv[1]).glob("*.typ"))
for file in files:
    try:
        typst.compile(str(file), output=str(file.with_suffix(".pdf")))
    except Exception as error:  # the wheel has its own kinds of errors
        print(f"{file}: {error}")
        bad += 1
print(f"typst: {len(files) - bad} documents")
sys.exit(1 if bad else 0)
