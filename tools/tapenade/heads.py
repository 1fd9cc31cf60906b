"""heads.txt: the functions that are differentiated.

read(path, kernel, make) gives one make(name=.., outputs=.., inputs=.., modes=.., sources=..,
integers=.., place=(file, line)) for each head; what is wrong raises HeadsError `heads.txt:12: why`.
"""

import re

MODES = ("d", "dv", "b", "b_d")

NAME = r"[A-Za-z_]\w*"
LINE = re.compile(
    rf"\s*(?P<name>{NAME})\s*\((?P<outputs>[^()]*)\)\s*/\s*\((?P<inputs>[^()]*)\)(?P<rest>.*)"
)


class HeadsError(Exception):
    """One line about one line of heads.txt."""

    def __init__(self, path, line, reason):
        super().__init__(f"{path.name}:{line}: {reason}")


def arguments(text):
    """Names between parentheses; raises ValueError."""
    names = text.split()
    for name in names:
        if not re.fullmatch(NAME, name):
            raise ValueError(f"`{name}` is not the name of an argument")
        if names.count(name) > 1:
            raise ValueError(f"argument {name} is listed twice")
    if not names:
        raise ValueError("no arguments between parentheses")
    return names


def parse(text, kernel):
    """One line without its comment, as a dictionary; raises ValueError."""
    match = LINE.fullmatch(text)
    if not match:
        raise ValueError("expected: function (outputs)/(inputs)  sources  modes  int=expression ..")
    head = {
        "name": match["name"],
        "outputs": arguments(match["outputs"]),
        "inputs": arguments(match["inputs"]),
        "modes": [],
        "sources": [],
        "integers": {},
    }
    for word in match["rest"].split():
        name, equals, expression = word.partition("=")
        if equals:
            if not re.fullmatch(NAME, name) or not expression:
                raise ValueError(f"`{word}` is not int=expression")
            if name in head["integers"]:
                raise ValueError(f"integer {name} is given twice")
            head["integers"][name] = expression
        elif word.endswith(".c"):
            if not (kernel / word).is_file():
                raise ValueError(f"no file {word} in {kernel.name}")
            if word in head["sources"]:
                raise ValueError(f"source {word} is listed twice")
            head["sources"].append(word)
        elif word in MODES:
            if word in head["modes"]:
                raise ValueError(f"mode {word} is listed twice")
            head["modes"].append(word)
        else:
            modes = ", ".join(MODES)
            raise ValueError(f"`{word}` is no source file, no mode ({modes}), no int=expression")
    if not head["sources"]:
        raise ValueError("no source file")
    if not head["modes"]:
        raise ValueError(f"no mode ({' '.join(MODES)})")
    if "b_d" in head["modes"] and "b" not in head["modes"]:
        raise ValueError("mode b_d, the tangent of the adjoint, needs mode b")
    return head


def read(path, kernel, make=dict):
    """All heads of a file, sources looked for in the folder kernel."""
    heads, lines = [], {}
    for number, text in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        text = text.partition("#")[0]
        if not text.strip():
            continue
        try:
            head = parse(text, kernel)
        except ValueError as error:
            raise HeadsError(path, number, error) from None
        if head["name"] in lines:
            first = lines[head["name"]]
            raise HeadsError(path, number, f"{head['name']} stands already in line {first}")
        lines[head["name"]] = number
        heads.append(make(**head, place=(path.name, number)))
    if not heads:
        raise HeadsError(path, 1, "no heads")
    return heads
