#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Links between the documents lead to files and headings that are there, every document in docs/ is linked from another
one, and the first page and the glossary stay short."""

import pathlib
import re
import sys

MOST_LINES_OF_README, MOST_WORDS_OF_GLOSSARY = 80, 50

root = pathlib.Path(__file__).resolve().parents[2]
complaints = []


def text_of(file):
    """Without blocks of code, whose brackets are no links."""
    return re.sub(r"^```.*?^```$", "", file.read_text(), flags=re.M | re.S)


def anchors(file):
    """As GitHub makes them from headings."""
    headings = re.findall(r"^#+ (.*)$", text_of(file), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links(file, linked):
    for link in re.findall(r"\]\(([^)\s]+)\)", text_of(file)):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (file.parent / name).resolve() if name else file
        if not target.exists():
            complaints.append(f"{file.relative_to(root)}: there is no {link}")
        elif anchor and anchor not in anchors(target):
            complaints.append(f"{file.relative_to(root)}: there is no heading for {link}")
        if target != file:
            linked.add(target)


documents = [root / "README.md"]
documents += [f for f in sorted(root.glob("*/**/*.md")) if not f.relative_to(root).parts[0].startswith("build")]
linked = set()
for document in documents:
    check_links(document, linked)
complaints += [f"no document links to docs/{f.name}" for f in sorted((root / "docs").glob("*.md")) if f not in linked]

lines = (root / "README.md").read_text().count("\n")
if lines > MOST_LINES_OF_README:
    complaints.append(f"README.md has {lines} lines, more than {MOST_LINES_OF_README}")
words = len(re.findall(r"^\| (?!word \|)\w", (root / "docs/glossary.md").read_text(), re.M))
if not 0 < words <= MOST_WORDS_OF_GLOSSARY:
    complaints.append(f"docs/glossary.md has {words} words, not 1 to {MOST_WORDS_OF_GLOSSARY}")

print("\n".join(complaints) or f"{len(documents)} documents")
sys.exit(bool(complaints))
