"""MANIFEST of ad_generated: what the files were made from, by what, and what they are.

    engine   built-in
    version  1
    command  tools/tapenade/generate
    tool     sha256  tools/tapenade/engine/ir.py    relative to the project
    read     sha256  core/kernel/position.c         the same
    written  sha256  position_d.c                   relative to the folder

cmake/check_generated.cmake looks at the last two, to see that nothing changed since.
"""

import hashlib
import re

NAME = "MANIFEST"


def sha256(content):
    return hashlib.sha256(content).hexdigest()


def with_headers(sources, folder):
    """Sources and what they include, directly or not, from the folder."""
    found, waiting = set(), list(sources)
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found.add(path)
        text = path.read_text(encoding="utf-8")
        for name in re.findall(r'^\s*#\s*include\s+"([^"]+)"', text, re.MULTILINE):
            if (folder / name).is_file():
                waiting.append(folder / name)
    return found


def write(root, engine, version, commands, tools, read, written):
    """The text of MANIFEST; commands: what was run, the first one to type."""
    lines = [f"engine   {engine}", f"version  {version}"]
    lines += [f"command  {command}" for command in commands]
    for verb, paths in ("tool   ", tools), ("read   ", read):
        for path in sorted(path.relative_to(root).as_posix() for path in paths):
            lines.append(f"{verb}  {sha256((root / path).read_bytes())}  {path}")
    for name in sorted(written):
        lines.append(f"written  {sha256(written[name].encode())}  {name}")
    return "\n".join(lines) + "\n"
