#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""package_files.py PROGRAM CHANGELOG FOLDER: what a package has in /usr/share for the program laplacian-lines, into the
folder: its manual page and its completion for bash, made from what its --help says, and what Debian wants."""
import datetime
import gzip
import pathlib
import re
import subprocess
import sys
import textwrap

NAME = "laplacian-lines"
CONTACT = "Laplacian Lines developers <laplacian-lines@localhost>"
COMPLETION = """# completion of bash for laplacian-lines
_laplacian_lines() {{
    local word=${{COMP_WORDS[COMP_CWORD]}} words=
    case ${{COMP_WORDS[COMP_CWORD - 1]}} in
{values}
    *) [[ $word != -* ]] || words="{options}" ;;
    esac
    local among=(-f)
    [[ ! $words ]] || among=(-W "$words")
    mapfile -t COMPREPLY < <(compgen "${{among[@]}}" -- "$word")
}}
complete -o filenames -F _laplacian_lines laplacian-lines
"""


def parse(text):
    """The help's pairs: what is to be written, what it means; of ways to call the program and of options."""
    calls, options = [], []
    for line in text.splitlines():
        call = re.fullmatch(rf"{NAME} (.*)", line)
        option = re.fullmatch(r" +(--[a-z-]+(?: \S+)?)(?: +(\S.*))?", line)
        if call:
            calls.append([call[1], ""])
        elif option:
            options.append([option[1], option[2] or ""])
        elif line.strip():
            (options or calls)[-1][1] += " " + line.strip()
    return calls, options


def roff(text):
    return re.sub(r"^([.'])", r"\\&\1", text.strip().replace("\\", "\\e").replace("-", "\\-"))


def manual(version, calls, options):
    lines = [f'.TH {NAME.upper()} 1 "" "{NAME} {version}"', ".SH NAME",
             f"{roff(NAME)} \\- measured line drawings of 3D scans, at scale on paper", ".SH SYNOPSIS"]
    lines += [line for what, _ in calls for line in (f".B {roff(NAME)}", roff(what), ".br")]
    for heading, rows in (("DESCRIPTION", calls), ("OPTIONS", options)):
        lines.append(f".SH {heading}")
        lines += [line for what, meaning in rows
                  for line in (".TP", f".B {roff(what)}", roff(re.sub(r"(?<![.)])$", ".", meaning)))]
    return "\n".join(lines) + "\n"


def completion(options):
    values = []
    for name, value in (what.split(" ") for what, _ in options if " " in what):
        words = [word for word in value.split("|") if re.fullmatch("[a-z][a-z0-9_]*", word) and "=" not in value]
        if words:
            values.append(f'    {name}) words="{" ".join(words)}" ;;')
    return COMPLETION.format(values="\n".join(values), options=" ".join(what.split(" ")[0] for what, _ in options))


def debian_changelog(text):
    entries = []
    for version, date, body in re.findall(r"^## (\S+) \((\S+)\)\n(.*?)(?=^## |\Z)", text, re.M | re.S):
        day = datetime.date.fromisoformat(date).strftime("%a, %d %b %Y 00:00:00 +0000")
        items = (" ".join(item.split()) for item in re.split(r"^- ", body, flags=re.M)[1:])
        changes = "\n".join(textwrap.fill(item, 76, initial_indent="  * ", subsequent_indent="    ") for item in items)
        entries.append(f"meshlab-laplacian-lines ({version}) unstable; urgency=medium\n\n{changes}\n\n -- {CONTACT}  {day}\n")
    return "\n".join(entries)


def packed(text):
    return gzip.compress(text.encode(), 9, mtime=0)


def main(program, changelog, folder):
    said, version = (subprocess.run([program, option], check=True, capture_output=True, text=True).stdout
                     for option in ("--help", "--version"))
    calls, options = parse(said)
    here = pathlib.Path(__file__).parent
    for name, content in {
            f"man/man1/{NAME}.1.gz": packed(manual(version.split()[1], calls, options)),
            f"bash-completion/completions/{NAME}": completion(options).encode(),
            f"doc/meshlab-{NAME}/changelog.gz": packed(debian_changelog(pathlib.Path(changelog).read_text(encoding="utf-8"))),
            f"doc/meshlab-{NAME}/copyright": (here / "copyright").read_bytes(),
            f"lintian/overrides/meshlab-{NAME}": (here / "lintian_overrides").read_bytes()}.items():
        file = pathlib.Path(folder, name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)


main(*sys.argv[1:])
