# SPDX-License-Identifier: GPL-3.0-or-later
"""Links between the documents lead to files and headings that are there, and every document in docs/ is linked."""

import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
complaints, linked = [], set()


def text_of(file):
    """Without blocks of code, whose brackets are no links."""
    return re.sub(r"^```.*?^```$", "", file.read_text(), flags=re.M | re.S)


def anchors(file):
    """As GitHub makes them from headings."""
    headings = re.findall(r"^#+ (.*)$", text_of(file), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


documents = [root / "README.md"]
documents += [f for f in sorted(root.glob("*/**/*.md")) if not f.relative_to(root).parts[0].startswith("build")]
for file in documents:
    for link in re.findall(r"\]\(([^)\s]+)\)", text_of(file)):
        name, _, anchor = link.partition("#")
        target = (file.parent / name).resolve() if name else file
        if re.match(r"[a-z]+:", link):
            continue
        if not target.exists() or anchor and anchor not in anchors(target):
            complaints.append(f"{file.relative_to(root)}: there is no {link}")
        linked |= {target} - {file}
complaints += [f"no document links to docs/{f.name}" for f in sorted((root / "docs").glob("*.md")) if f not in linked]

print("\n".join(complaints) or f"{len(documents)} documents")
sys.exit(bool(complaints))
