# SPDX-License-Identifier: GPL-3.0-or-later
"""Links between the documents lead to files and headings that are there; every document in docs/ is linked, and begins
with a picture or a command."""

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
    for link in re.findall(r"(?:\]\(|src=\")([^)\s\"]+)[)\"]", text_of(file)):
        name, _, anchor = link.partition("#")
        target = (file.parent / name).resolve() if name else file
        if re.match(r"[a-z]+:|\.\./\.\./actions/", link):  # on the web; GitHub's pages beside the files
            continue
        if not target.exists() or anchor and anchor not in anchors(target):
            complaints.append(f"{file.relative_to(root)}: there is no {link}")
        linked |= {target} - {file}
for file in sorted((root / "docs").glob("*.md")):
    if file not in linked:
        complaints.append(f"no document links to docs/{file.name}")
    if not re.match(r"(<!--.*-->\n)?# .*\n\n(```|!\[)", file.read_text()):
        complaints.append(f"docs/{file.name} does not begin with a picture or a command")

print("\n".join(complaints) or f"{len(documents)} documents")
sys.exit(bool(complaints))
