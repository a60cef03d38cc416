#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""package_files.py PROGRAM CHANGELOG FOLDER: what a package has beside the program laplacian-lines, made from what its
--help and the changelog say: the manual page laplacian-lines.1.gz, the completion of bash laplacian-lines, and
changelog.gz as Debian has it."""
import datetime
import gzip
import pathlib
import re
import subprocess
import sys
import textwrap

NAME = "laplacian-lines"
SUMMARY = "measured line drawings of 3D scans, at scale on paper"
CONTACT = "Laplacian Lines developers <laplacian-lines@localhost>"
COMPLETION = """# completion of bash for laplacian-lines
_laplacian_lines() {{
    local word=${{COMP_WORDS[COMP_CWORD]}}
    case ${{COMP_WORDS[COMP_CWORD - 1]}} in
{values}
    *)
        if [[ $word == -* ]]; then
            mapfile -t COMPREPLY < <(compgen -W "{options}" -- "$word")
        else
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
        fi
        ;;
    esac
}}
complete -o filenames -F _laplacian_lines laplacian-lines
"""


def parse(text):
    """The help's blocks: (what is to be written, what it means), of ways to call the program and of options."""
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
    return re.sub(r"^([.'])", r"\\&\1", text.replace("\\", "\\e").replace("-", "\\-"))


def manual(version, calls, options):
    lines = [f'.TH {NAME.upper()} 1 "" "{NAME} {version}"', ".SH NAME", f"{roff(NAME)} \\- {SUMMARY}", ".SH SYNOPSIS"]
    for what, _ in calls:
        lines += [f".B {roff(NAME)}", roff(what), ".br"]
    lines.append(".SH DESCRIPTION")
    for what, meaning in calls:
        lines += [".TP", f".B {roff(what)}", roff(meaning.strip()[:1].upper() + meaning.strip()[1:]) + "."]
    lines.append(".SH OPTIONS")
    for what, meaning in options:
        lines += [".TP", f".B {roff(what)}", roff(meaning.strip())]
    return "\n".join(lines) + "\n"


def completion(options):
    values = []
    for name, value in (what.split(" ") for what, _ in options if " " in what):
        words = [word for word in value.split("|") if re.fullmatch("[a-z][a-z0-9_]*", word) and "=" not in value]
        action = '-W "{}"'.format(" ".join(words)) if words else "-f" if value == "FILE" else ""
        reply = f'mapfile -t COMPREPLY < <(compgen {action} -- "$word")' if action else "COMPREPLY=()"
        values.append(f"    {name}) {reply} ;;")
    return COMPLETION.format(values="\n".join(values), options=" ".join(what.split(" ")[0] for what, _ in options))


def debian_changelog(text):
    entries = []
    for version, date, body in re.findall(r"^## (\S+) \((\S+)\)\n(.*?)(?=^## |\Z)", text, re.M | re.S):
        day = datetime.date.fromisoformat(date).strftime("%a, %d %b %Y 00:00:00 +0000")
        items = (" ".join(item.split()) for item in re.split(r"^- ", body, flags=re.M)[1:])
        changes = "\n".join(textwrap.fill(item, 76, initial_indent="  * ", subsequent_indent="    ") for item in items)
        entries.append(f"meshlab-laplacian-lines ({version}) unstable; urgency=medium\n\n{changes}\n\n -- {CONTACT}  {day}\n")
    return "\n".join(entries)


def write_compressed(file, text):
    file.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def main(program, changelog, folder):
    ask = lambda option: subprocess.run([program, option], check=True, capture_output=True, text=True).stdout
    calls, options = parse(ask("--help"))
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    write_compressed(folder / f"{NAME}.1.gz", manual(ask("--version").split()[1], calls, options))
    write_compressed(folder / "changelog.gz", debian_changelog(pathlib.Path(changelog).read_text(encoding="utf-8")))
    (folder / NAME).write_text(completion(options), encoding="utf-8")


main(*sys.argv[1:])
