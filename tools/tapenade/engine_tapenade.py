"""The second engine: Tapenade 3.16 on the same heads; its results are the same files and functions.

Each source file of the kernel becomes one file for Tapenade, with what its heads call and nothing
else, and is differentiated in each mode.  Heads are given with all their active arguments on both
sides, f(outputs inputs)/(inputs outputs): so the adjoints of inputs are accumulated, which Tapenade
calls `incr`, and derivatives of what is not written stay as they are.  What Tapenade writes becomes
static, and a function with the signature of the built-in engine calls it: on copies of the outputs,
because Tapenade computes them once more and our callers hold them already.

Tapenade's exit status says nothing: a message in a .msg file, a file that is missing, a function
with other arguments than expected, adjoints of inputs that are overwritten, and C that does not
compile are errors.
"""

import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

from pycparser import c_ast, c_generator, c_parser

import engine
from engine import write
from engine.front import _preprocess as preprocess

HERE = pathlib.Path(__file__).resolve().parent
RUNTIME = HERE / "runtime"

OPTIONS = {"d": ["-d"], "dv": ["-d", "-vector"], "b": ["-b"], "b_d": ["-d"]}
TITLE = {"d": "Tangent", "dv": "Vector tangent", "b": "Adjoint", "b_d": "Tangent of the adjoint"}
TIMEOUT = 600  # seconds for one run

# what Tapenade differentiates itself; what else is called must be in the sources
INTRINSICS = set("sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt pow fabs".split())
# headers that its output includes, and what stands for them
HEADERS = {"math.h", "adStack.h", "adBuffer.h", "DIFFSIZES.inc", "DIFFSIZES.h"}
STACK = re.compile(r"\b(?:push|pop)(?:Real|Integer|Pointer|Control)\w+|\badStack_\w+")
WARNINGS = ("missing-prototypes", "shadow", "strict-prototypes", "uninitialized",
            "unused-but-set-variable", "unused-function", "unused-parameter", "unused-variable")


class TapenadeError(Exception):
    """What went wrong, in one line."""


class Kernel:
    """Functions of the sources, and one of them with all that it calls as a text for Tapenade."""

    def __init__(self, sources, include):
        self.functions, self.types, self.file = {}, {}, {}
        for path in sources:
            text = preprocess(str(path), include, ())
            for node in c_parser.CParser().parse(text, str(path)).ext:
                if isinstance(node, c_ast.FuncDef):
                    self.functions[node.decl.name] = node
                    self.file[node.decl.name] = pathlib.Path(path).stem
                elif isinstance(node, c_ast.Typedef):
                    self.types[node.name] = node
        self.enumerators = engine.Program(sources, include).enumerators

    def closure(self, name, found):
        """name after all that it calls"""
        if name in found:
            return
        calls = Calls()
        calls.visit(self.functions[name])
        for called in sorted(calls.names - INTRINSICS - {"MAGGI_RE"}):
            if called not in self.functions:
                raise TapenadeError(f"{name} calls {called}, which is in none of the sources of "
                                    "heads.txt and which Tapenade does not know")
            self.closure(called, found)
        found[name] = self.functions[name]

    def text(self, heads):
        """The heads as one file; enumerators are written as numbers."""
        found = {}
        for head in heads:
            self.closure(head.name, found)
        generator = c_generator.CGenerator()
        code = "\n".join(generator.visit(node) for node in found.values())
        types = [generator.visit(node) + ";\n\n" for name, node in self.types.items()
                 if re.search(rf"\b{name}\b", code)]
        text = "".join(types) + re.sub(r"^static ", "", code, flags=re.MULTILINE)
        text = re.sub(r"\bMAGGI_RE\b", "", text)
        text = re.sub(r"\b[A-Z]\w*\b",
                      lambda word: str(self.enumerators.get(word[0], word[0])), text)
        return "#include <math.h>\n\n" + text


class Calls(c_ast.NodeVisitor):
    def __init__(self):
        self.names = set()

    def visit_FuncCall(self, node):
        self.names.add(node.name.name)
        self.generic_visit(node)


def parameters(text, what):
    """Functions that C text of Tapenade defines: name -> names of its parameters."""
    plain = re.sub(r"/\*.*?\*/|//[^\n]*|^[ \t]*#[^\n]*", "", text, flags=re.DOTALL | re.MULTILINE)
    try:
        tree = c_parser.CParser().parse(plain, what)
    except (c_parser.ParseError, AssertionError, RecursionError) as error:
        raise TapenadeError(f"{what} as Tapenade wrote it is not C: {error}") from None
    found = {}
    for node in tree.ext:
        if isinstance(node, c_ast.FuncDef):
            arguments = node.decl.type.args
            found[node.decl.name] = [p.name for p in arguments.params] if arguments else []
    return found


class Run:
    """Tapenade on one file in one mode."""

    def __init__(self, program, folder, source, mode):
        self.program, self.folder, self.source, self.mode = program, folder, source, mode
        self.what = f"tapenade, {source}, mode {mode}"

    def command(self, heads, rules):
        options = ["-fixinterface", "-copyname", f"%_nd_{self.mode}"]
        if rules:
            options += ["-ext", rules]
        for head in heads:
            options += ["-head", head]
        return [*OPTIONS[self.mode], *options, "-O", self.mode, self.source]

    def run(self, heads, rules=None):
        """The text of the file that Tapenade writes, and the command."""
        suffix = "d" if self.mode == "b_d" else self.mode
        output = self.folder / self.mode
        output.mkdir()
        command = self.command(heads, rules)
        try:
            done = subprocess.run([self.program, *command], cwd=self.folder, timeout=TIMEOUT,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True,
                                  stderr=subprocess.STDOUT, errors="replace", check=False)
        except subprocess.TimeoutExpired:
            raise TapenadeError(f"{self.what}: no end after {TIMEOUT} s") from None
        except OSError as error:
            raise TapenadeError(f"cannot run {self.program}: {error.strerror}") from None
        said = [line.strip() for line in done.stdout.splitlines() if line.strip()]
        if done.returncode:
            raise TapenadeError(f"{self.what}: status {done.returncode}: "
                                f"{said[-1] if said else 'without a word'}")
        for line in said:
            if re.search(r"Exception\b|[Ss]yntax error|^(?:Error|System):|[Uu]nknown option", line):
                raise TapenadeError(f"{self.what}: {line}")
        for path in sorted(output.glob("*.msg")):
            messages = [x.strip() for x in path.read_text(errors="replace").splitlines()
                        if x.strip()]
            if messages:
                more = f" (and {len(messages) - 1} lines more)" if len(messages) > 1 else ""
                raise TapenadeError(f"{self.what}: {messages[0]}{more}")
        written = output / f"{pathlib.Path(self.source).stem}_{suffix}.c"
        if not written.is_file():
            raise TapenadeError(f"{self.what}: it wrote no {written.name}"
                                + (f"; its last words: {said[-1]}" if said else ""))
        shown = ["rules" if word == rules else word for word in command]
        return written.read_text(errors="replace"), "tapenade " + shlex.join(shown)


def without_includes(text, what):
    for name in re.findall(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', text, re.MULTILINE):
        if name not in HEADERS:
            raise TapenadeError(f"{what}: it includes {name}, of which nothing is known")
    return re.sub(r"^[ \t]*#[ \t]*include[^\n]*\n", "", text, flags=re.MULTILINE)


def check_adjoints(text, heads, what):
    """Tapenade says of each adjoint whether it is added to (incr), consumed (in-out, in-zero) or
    overwritten (out): the last is not what callers expect."""
    for head in heads:
        match = re.search(rf"Differentiation of {head.name} in reverse.*?"
                          r"RW status of diff variables:(.*?)(?:Plus diff|\*/)", text, re.DOTALL)
        if not match:
            continue
        status = dict(re.findall(r"[*(]*(\w+)[\w\[\]:()+*-]*?:([a-z-]+)\b", match[1]))
        for name in head.inputs + head.outputs:
            allowed = {"incr", "in", "in-out"} | (set() if name in head.inputs else {"in-zero"})
            if status.get(name, "incr") not in allowed:
                raise TapenadeError(f"{what}: the adjoint of {name} of {head.name} is "
                                    f"`{status[name]}`, where it should be accumulated or consumed")


def with_real_parts(text):
    """Comparisons in `if` through MAGGI_RE, for the complex-step build of the tests."""
    parser, generator = c_parser.CParser(), c_generator.CGenerator()

    def compared(node):
        for name in ("left", "right", "expr"):
            if isinstance(getattr(node, name, None), c_ast.Node):
                compared(getattr(node, name))
        if isinstance(node, c_ast.BinaryOp) and node.op in ("<", ">", "<=", ">="):
            for name in ("left", "right"):
                call = c_ast.FuncCall(c_ast.ID("MAGGI_RE"), c_ast.ExprList([getattr(node, name)]))
                setattr(node, name, call)

    out, at = [], 0
    for match in re.finditer(r"\bif \(", text):
        depth, end = 1, match.end()
        while depth and end < len(text):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        condition = text[match.end():end - 1]
        if re.search(r"[<>]", condition) and "MAGGI_RE" not in condition:
            tree = parser.parse(f"void f(void) {{ if ({condition}) ; }}")
            node = tree.ext[0].body.block_items[0]
            compared(node.cond)
            out += [text[at:match.end()], generator.visit(node.cond)]
            at = end - 1
    return "".join(out) + text[at:]


def private(text, functions, types):
    """Functions and types of Tapenade's text under names of its own, functions static."""
    for name in functions:
        text = re.sub(rf"^(?:static\s+)?((?:void|double|int)\s+{name}\s*\()", r"static \1", text,
                      flags=re.MULTILINE)
    for name in [*functions, *types]:
        text = re.sub(rf"\b{name}\b", f"tapenade_{name}", text)
    return text


class Wrapper:
    """The function that callers see: it calls Tapenade's one on copies of the outputs."""

    def __init__(self, prototype, head, mode, plain):
        self.prototype, self.head, self.mode = prototype, head, mode
        self.name = f"{head.name}_{mode}"
        self.declared = {}  # name -> declaration, in order
        depth, item = 0, ""
        for c in prototype[prototype.index("(") + 1:prototype.rindex(")")] + ",":
            depth += {"[": 1, "(": 1, "]": -1, ")": -1}.get(c, 0)
            if c == "," and depth == 0:
                declaration = " ".join(item.split())
                self.declared[re.match(r"[^\[]*?(\w+)(?:\[.*)?$", declaration)[1]] = declaration
                item = ""
            else:
                item += c
        self.plain = plain

    def arguments(self, written, what):
        """Our argument for each parameter of Tapenade's function: every active argument is followed
        by its derivatives, in the tangent of the adjoint every parameter of the adjoint."""
        active = set(self.head.inputs + self.head.outputs)
        suffixes = {"d": ["d"], "dv": ["d"], "b": ["b"], "b_d": ["d", "b", "bd"]}[self.mode]
        rest, found = list(written), []
        for i, name in enumerate(self.plain):
            if not rest or rest.pop(0) != name:
                raise TapenadeError(f"{what}: {self.name} has no argument {name} where it should")
            companions = []
            following = self.plain[i + 1] if i + 1 < len(self.plain) else None
            while rest and rest[0] != following and rest[0] != "nbdirs":
                companions.append(rest.pop(0))
            expected = [name + s for s in suffixes] if name in active else []
            if self.mode == "b_d" and len(companions) == 2 and name in self.head.outputs:
                expected = expected[1:]  # nothing depends on the value of an output
            if len(companions) != len(expected):
                raise TapenadeError(f"{what}: {self.name} has {len(companions)} derivatives of "
                                    f"{name}, not {len(expected)}")
            found += [name, *expected]
        if rest != (["nbdirs"] if self.mode == "dv" else []):
            raise TapenadeError(f"{what}: {self.name} has unknown arguments {' '.join(rest)}")
        return found + rest

    def text(self, written, what):
        passed = self.arguments(written, what)
        copied = [n for n in self.head.outputs if n in passed]
        if self.mode == "b_d":
            copied += [n + "d" for n in self.head.outputs if n + "d" in passed]
        head, body, call = [], [], []
        for name in copied:
            rows, rest = re.search(r"\[restrict ([^\]]*)\](.*)$", self.declared[name]).groups()
            head.append(f"  double copy_{name}[{rows} + 1]{rest};")
            body.append(f"  memcpy(copy_{name}, {name}, "
                        f"(size_t)({rows}) * sizeof copy_{name}[0]);")
        for name in passed:
            shown = f"copy_{name}" if name in copied else name
            pointer = "[" in self.declared[name] or "*" in self.declared[name]
            call.append(f"(void *){shown}" if pointer else shown)
        unused = [f"  (void){name};" for name in self.declared if name not in passed]
        if head:
            head.append("")
        body += write.wrap(f"tapenade_{self.name}({', '.join(call)});", 1)
        return "\n".join(["", self.prototype.rstrip(";"), "{", *head, *unused, *body, "}", ""])


class File:
    """One source file of the kernel in all its modes."""

    def __init__(self, program, kernel, base, heads, header, folder):
        self.program, self.kernel, self.base, self.heads = program, kernel, base, heads
        self.header, self.folder = header, folder / base
        self.commands = []
        self.version = "?"

    def run(self):
        """{file name: text}"""
        self.folder.mkdir()
        (self.folder / f"{self.base}.c").write_text(self.kernel.text(self.heads))
        files = {}
        for mode in ("d", "dv", "b", "b_d"):
            heads = [head for head in self.heads if mode in head.modes]
            if heads:
                files[f"{self.base}_{mode}.c"] = self.differentiate(mode, heads)
        return files

    def differentiate(self, mode, heads):
        source, rules = f"{self.base}.c", None
        if mode == "b_d":
            source, rules = f"{self.base}_b.c", self.write_adjoint()
        run = Run(self.program, self.folder, source, mode)
        text, command = run.run([self.described(head, mode) for head in heads], rules)
        self.commands.append(command)
        version = re.search(r"Tapenade (\d\S*(?: \([^)]*\))?)", text)
        self.version = version[1] if version else self.version
        text = without_includes(text, run.what)
        functions = parameters(text, run.what)
        for head in heads:
            if f"{head.name}_{mode}" not in functions:
                raise TapenadeError(f"{run.what}: it wrote no function {head.name}_{mode}")
        if mode == "b":
            check_adjoints(text, heads, run.what)
            self.adjoint = text
        return self.finished(text, mode, heads, functions, run.what)

    def described(self, head, mode):
        if mode == "b_d":
            x, y = head.inputs, [n for n in head.outputs if n not in head.inputs]
            adjoints = [n + "b" for n in x + y]
            return f"{head.name}_b({','.join(adjoints)})/({','.join(x + adjoints)})"
        both = list(dict.fromkeys(head.inputs + head.outputs))
        outputs = head.outputs if mode in ("d", "dv") else both
        return f"{head.name}({','.join(outputs)})/({','.join(both)})"

    def write_adjoint(self):
        """Tapenade's adjoint as a source, with prototypes of the stack; its rules where it needs
        any."""
        used = sorted(set(STACK.findall(self.adjoint)))
        header = (RUNTIME / "adStack.h").read_text()
        declared = [x for x in re.findall(r"^void \w+\([^)]*\);", header, re.MULTILINE)]
        declared = [x for x in declared if re.match(r"void (\w+)", x)[1] in used]
        text = "#include <math.h>\n\n" + "\n".join([*declared, "", self.adjoint])
        (self.folder / f"{self.base}_b.c").write_text(text)
        if not any("Real" in name for name in used):
            return None
        home = pathlib.Path(os.path.realpath(self.program)).parents[1]
        rules = home / "ADFirstAidKit" / "PUSHPOPGeneralLib"
        if not rules.is_file():
            raise TapenadeError(f"the adjoint of {self.base}.c uses the stack, and there is no "
                                f"{rules} to differentiate it by")
        return str(rules)

    def finished(self, text, mode, heads, functions, what):
        """The file with wrappers, compiled."""
        text = with_real_parts(private(text, functions, self.kernel.types))
        lines = [f"/* {TITLE[mode]} of core/kernel/{self.base}.c, by Tapenade {self.version}.",
                 " * Written by tools/tapenade/generate: edit the kernel. */",
                 "#include <string.h>", "", '#include "adStack.h"', '#include "maggi_ad.h"', ""]
        if mode == "dv":
            lines += ["#define NBDirsMax MAGGI_NDIR", ""]
        lines += [f'#pragma GCC diagnostic ignored "-W{name}"' for name in WARNINGS]
        result = "\n".join([*lines, "", text.strip(), ""])
        for head in heads:
            name = f"{head.name}_{mode}"
            prototype = re.search(rf"^void {name}\([^;]*;", self.header, re.MULTILINE)[0]
            plain = [p.name for p in self.kernel.functions[head.name].decl.type.args.params]
            wrapper = Wrapper(prototype, head, mode, plain)
            result += wrapper.text(functions[name], what)
        return result


def compile_all(files, include):
    """Every file must compile."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file, text in files.items():
            (folder / file).write_text(text)
        for file in sorted(files):
            if not file.endswith(".c"):
                continue
            command = [*shlex.split(os.environ.get("CC", "cc")), "-std=gnu17", "-fsyntax-only",
                       "-Werror=implicit-function-declaration", f"-I{folder}", f"-I{RUNTIME}",
                       *(f"-I{path}" for path in include), str(folder / file)]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode:
                first = next((x for x in done.stderr.splitlines() if "error" in x), "it fails")
                raise TapenadeError("what Tapenade wrote does not compile: "
                                    + first.replace(f"{folder}/", ""))


def differentiate(sources, heads, include, program=None, includes=("kernel.h",)):
    """({file name: text}, version, commands), as engine.differentiate(); raises TapenadeError."""
    program = program or shutil.which("tapenade")
    if not program:
        raise TapenadeError("no program `tapenade` in PATH: give --tapenade /path/to/bin/tapenade")
    if not os.access(program, os.X_OK) or os.path.isdir(program):
        raise TapenadeError(f"{program} is not a program")
    program = os.path.abspath(program)
    sources = [str(path) for path in sources]
    # header and table are those of the built-in engine, which also says what the subset refuses
    ours = engine.differentiate(sources, heads, include, includes=includes)
    files = {name: ours[name] for name in ("maggi_ad.h", "heads.c")}
    kernel = Kernel(sources, include)
    groups = {}
    for head in heads:
        groups.setdefault(kernel.file[head.name], []).append(head)
    with tempfile.TemporaryDirectory(prefix="maggi-tapenade-") as name:
        parts = [File(program, kernel, base, group, files["maggi_ad.h"], pathlib.Path(name))
                 for base, group in sorted(groups.items())]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for result in pool.map(File.run, parts):
                files.update(result)
    compile_all(files, include)
    commands = [command for part in parts for command in part.commands]
    return files, parts[0].version, commands
