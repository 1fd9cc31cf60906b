"""From C to statements: preprocessing, parsing, and what the subset refuses at first sight."""
from __future__ import annotations

import os
import re
import shlex
import subprocess

from pycparser import c_ast, c_parser
from pycparser.c_parser import ParseError

from . import ir
from .inline import fold
from .ir import Assign, Bin, Call, Cond, For, If, Invoke, Num, Ref, Refusal, Return, Un, Var

HERE = os.path.dirname(os.path.abspath(__file__))


class Program:
    """All functions of some C files, by name, and the values of their enumerators."""

    def __init__(self, paths, include_dirs=(), defines=()):
        self.functions = {}
        self.static = {}  # by path and name
        self.declared = set()  # in headers
        self.enumerators = {}
        self.own_enumerators = {}  # path -> those that no header declares
        self.tables = {}  # constants that no header declares, by path and name -> text
        for path in paths:
            _File(self, path, include_dirs, defines)

    def find(self, name, path):
        """the function that a name means in a file"""
        return self.static.get((path, name)) or self.functions.get(name)


def _preprocess(path, include_dirs, defines):
    command = shlex.split(os.environ.get("CC", "cc")) + [
        "-E", "-nostdinc", "-undef", "-DMAGGI_RE=MAGGI_RE", "-I" + os.path.join(HERE, "include")]
    command += [f"-I{d}" for d in include_dirs] + [f"-D{d}" for d in defines]
    try:
        done = subprocess.run(command + [str(path)], capture_output=True, text=True, check=False)
    except OSError as error:
        raise Refusal(path, 1, f"cannot run the C preprocessor: {error.strerror}") from error
    if done.returncode:
        first = next((x for x in done.stderr.splitlines() if "error" in x), "it failed")
        raise Refusal(path, 1, f"preprocessor: {first}")
    # what only compilers need
    text = re.sub(r"__attribute__\s*\(\(.*?\)\)", "", done.stdout)
    return re.sub(r"^\s*#\s*pragma.*$", "", text, flags=re.M)


def _comments(text):
    """comments by the line of their end, as lists of lines"""
    found = {}
    for m in re.finditer(r"/\*(.*?)\*/", text, flags=re.S):
        start = text.rfind("\n", 0, m.start()) + 1
        if text[start:m.start()].strip():
            continue  # behind code
        end = text.count("\n", 0, m.end()) + 1
        lines = [re.sub(r"^ ?\* ?", "", x.strip() if i == 0 else x.lstrip()).rstrip()
                 for i, x in enumerate(m.group(1).split("\n"))]
        while lines and not lines[0]:
            lines.pop(0)
        while lines and not lines[-1]:
            lines.pop()
        found[end] = tuple(lines)
    return found


class _File:
    def __init__(self, program, path, include_dirs, defines):
        self.program = program
        self.f, self.globals, self.scopes = None, {}, []
        self.path = path = str(path)
        try:
            with open(path, encoding="utf-8") as f:
                self.source = f.read()
        except OSError as error:
            raise Refusal(path, 1, f"cannot be read: {error.strerror}") from error
        self.lines = self.source.split("\n")
        self.comments = _comments(self.source)
        text = _preprocess(path, include_dirs, defines)
        parser = c_parser.CParser()
        try:
            tree = parser.parse(text, path)
        except ParseError as error:
            m = re.match(r"(.*?):(?:(\d+):)?(?:\d+:)? *(.*)", str(error))
            line = int(m.group(2) or getattr(parser.clex, "_lineno", 1))
            raise Refusal(m.group(1), line, f"a syntax error: {m.group(3)}") from error
        for node in tree.ext:
            if isinstance(node, c_ast.FuncDef):
                self.function(node)
            elif isinstance(node, c_ast.Decl):
                self.declaration(node)
            elif isinstance(node, c_ast.Typedef):
                self.enums(node.type)

    # -------------------------------------------------------------------------- places, comments

    def place(self, node):
        coord = getattr(node, "coord", None)
        return (coord.file, coord.line) if coord else (self.path, 1)

    def refuse(self, node, reason):
        raise Refusal(*self.place(node), reason)

    def comment(self, node):
        file, line = self.place(node)
        return self.comments.get(line - 1, ()) if file == self.path else ()

    # ----------------------------------------------------------------------------- declarations

    def enums(self, node):
        while not isinstance(node, c_ast.Enum):
            node = getattr(node, "type", None)
            if node is None:
                return
        value = -1
        for e in node.values.enumerators if node.values else ():
            value += 1
            if e.value is not None:
                v = self.fold(self.expr(e.value))
                value = v if v is not None else value
            self.program.enumerators[e.name] = value
            if self.place(e)[0] == self.path:
                self.program.own_enumerators.setdefault(self.path, set()).add(e.name)

    def fold(self, e):
        return ir.integer(fold(e, self.program.enumerators))

    def declaration(self, node):
        self.enums(node.type)
        if isinstance(node.type, c_ast.FuncDecl) and self.place(node)[0] != self.path:
            self.program.declared.add(node.name)
        if isinstance(node.type, c_ast.FuncDecl) or node.name is None:
            return
        if "typedef" in node.storage or "extern" in node.storage:
            return
        inner = node.type
        while isinstance(inner, c_ast.ArrayDecl):
            inner = inner.type
        if "const" not in node.quals and "const" not in getattr(inner, "quals", ()):
            self.globals[node.name] = node
        elif self.place(node)[0] == self.path:
            line = self.place(node)[1]
            end = next((i for i, x in enumerate(self.lines) if i >= line - 1 and ";" in x), line)
            self.program.tables[self.path, node.name] = "\n".join(self.lines[line - 1:end + 1])

    def base_type(self, node):
        """("int" | "double" | other text, const)"""
        if isinstance(node, c_ast.TypeDecl):
            if isinstance(node.type, c_ast.IdentifierType):
                return " ".join(node.type.names), "const" in node.quals
            if isinstance(node.type, c_ast.Enum):
                return "int", "const" in node.quals
            if isinstance(node.type, (c_ast.Struct, c_ast.Union)):
                word = "struct" if isinstance(node.type, c_ast.Struct) else "union"
                return f"{word} {node.type.name or ''}".strip(), "const" in node.quals
        return "", False

    def parameter(self, node):
        if isinstance(node, c_ast.EllipsisParam):
            self.refuse(node, "a variable number of arguments")
        name, t = node.name, node.type
        if isinstance(t, c_ast.PtrDecl):
            base, const = self.base_type(t.type)
            if isinstance(t.type, c_ast.FuncDecl):
                self.refuse(node, f"`{name}` is a pointer to a function")
            if base in ("double", "float", "int"):
                self.refuse(node, f"`{name}` is a bare pointer: say how long the array is")
            if isinstance(t.type, c_ast.PtrDecl) or not base:
                self.refuse(node, f"`{name}` is a pointer to a pointer")
            return ir.Parameter(name, "topo", (), const, base)
        if isinstance(t, c_ast.FuncDecl):
            self.refuse(node, f"`{name}` is a pointer to a function")
        if isinstance(t, c_ast.ArrayDecl):
            dims = []
            while isinstance(t, c_ast.ArrayDecl):
                if t.dim_quals:
                    self.refuse(node, f"`{name}`: `{' '.join(map(str, t.dim_quals))}` in brackets")
                dims.append(self.expr(t.dim) if t.dim is not None else None)
                t = t.type
            base, const = self.base_type(t)
            if base == "double":
                if len(dims) > 2:
                    self.refuse(node, f"`{name}` has more than two dimensions")
                return ir.Parameter(name, "array", tuple(dims), const)
            if base == "int":
                return ir.Parameter(name, "ints", tuple(dims), const)
            self.refuse(node, f"`{name}` is an array of {base or 'pointers'}")
        base, const = self.base_type(t)
        if base == "double":
            return ir.Parameter(name, "double", (), False)
        if base == "int":
            return ir.Parameter(name, "int", (), False)
        self.refuse(node, f"`{name}` is passed by value and is neither int nor double ({base})")

    def function(self, node):
        decl = node.decl
        result, _ = self.base_type(decl.type.type)
        if isinstance(decl.type.type, c_ast.PtrDecl):
            result = "pointer"
        f = ir.Function(decl.name, result, place=self.place(decl), comment=self.comment(decl),
                        static="static" in decl.storage)
        f.text = self.text_of(f.place[1]) if f.place[0] == self.path else ""
        args = decl.type.args.params if decl.type.args else []
        if len(args) == 1 and getattr(args[0], "name", None) is None:
            args = []
        if f.static:
            self.program.static[self.path, f.name] = f
        else:
            self.program.functions[f.name] = f
        f.node, f.file, f.args = node, self, args

    def text_of(self, line):
        depth, out = 0, []
        for x in self.lines[line - 1:]:
            out.append(x)
            depth += x.count("{") - x.count("}")
            if depth == 0 and "}" in x:
                return "\n".join(out)
        return "\n".join(out)

    # --------------------------------------------------------------------------------- functions

    def convert(self, f):
        """parameters, locals and body; only of functions that are differentiated"""
        if f.body is not None:
            return
        self.f = None
        f.params = [self.parameter(a) for a in f.args]
        if f.kind not in ("void", "double", "int"):
            self.refuse(f.node.decl, f"`{f.name}` returns neither double nor int nor void")
        f.locals = {}
        self.f = f
        f.body = self.block(f.node.body.block_items or [])

    def local(self, node):
        t, dims = node.type, []
        if "static" in node.storage:
            self.refuse(node, f"`{node.name}` is static: it keeps a value between calls")
        if isinstance(t, c_ast.PtrDecl):
            self.refuse(node, f"`{node.name}` is a local pointer")
        while isinstance(t, c_ast.ArrayDecl):
            if t.dim is None:
                self.refuse(node, f"`{node.name}` is an initialised array: say how long it is")
            e = self.expr(t.dim)
            e = fold(e, self.program.enumerators)
            if ir.integer(e) is None:
                self.refuse(node, f"`{node.name}` is a local array of variable length")
            dims.append(ir.integer(e))
            t = t.type
        base, const = self.base_type(t)
        if base not in ("int", "double"):
            self.refuse(node, f"`{node.name}` is a local {base or 'pointer'}")
        if const:
            self.refuse(node, f"`{node.name}` is a const local: the adjoint would read it unset")
        if node.init is not None and base == "double":
            self.refuse(node, f"`{node.name}` is initialised where it is declared: assign to it")
        if self.parameter_of(node.name) or node.name in self.scopes[-1]:
            self.refuse(node, f"`{node.name}` is declared twice")
        name, kind = node.name, (base, tuple(dims))
        hidden = any(node.name in x for x in self.scopes)
        while name in self.f.locals and (hidden or self.f.locals[name] != kind):
            name += "_"
        self.scopes[-1][node.name] = name
        self.f.locals[name] = kind
        if node.init is not None:
            if dims:
                self.refuse(node, f"`{node.name}` is initialised where it is declared")
            return [Assign(self.place(node), (), Var(name), "=", self.expr(node.init))]
        return []

    def visible(self, name):
        """what a name means here: locals of blocks may hide others"""
        return next((x[name] for x in reversed(self.scopes) if name in x), name)

    def parameter_of(self, name):
        return self.f.parameter(name) if self.f else None

    def block(self, items):
        self.scopes.append({})
        out = [s for node in items for s in self.statement(node)]
        self.scopes.pop()
        return out

    def body(self, node):
        return self.block(node.block_items or []) if isinstance(node, c_ast.Compound) else \
            self.statement(node)

    def statement(self, node):
        where, comment = self.place(node), self.comment(node)
        if isinstance(node, c_ast.Decl):
            return self.local(node)
        if isinstance(node, c_ast.DeclList):
            return [s for d in node.decls for s in self.local(d)]
        if isinstance(node, c_ast.Assignment):
            return [self.assignment(node, where, comment)]
        if isinstance(node, c_ast.If):
            return [If(where, comment, self.expr(node.cond), self.body(node.iftrue),
                       self.body(node.iffalse) if node.iffalse else [])]
        if isinstance(node, c_ast.For):
            return self.loop(node, where, comment)
        if isinstance(node, c_ast.Switch):
            return [self.switch(node, where, comment)]
        if isinstance(node, c_ast.Compound):
            return self.block(node.block_items or [])
        if isinstance(node, c_ast.Return):
            if node.expr is None:
                self.refuse(node, "early return in a differentiated function")
            return [Return(where, comment, self.expr(node.expr))]
        if isinstance(node, c_ast.FuncCall):
            name = self.callee(node)
            if name in ("memcpy", "memset", "memmove"):
                self.refuse(node, f"`{name}` on active data")
            return [Invoke(where, comment, name, self.arguments(node))]
        if isinstance(node, c_ast.UnaryOp) and node.op in ("p++", "p--", "++", "--"):
            target = self.expr(node.expr)
            op = "+=" if "+" in node.op else "-="
            return [Assign(where, comment, target, op, Num("1"))]
        if isinstance(node, (c_ast.EmptyStatement, c_ast.Pragma)):
            return []
        if isinstance(node, c_ast.Cast):  # (void)x;
            return []
        words = {c_ast.While: "a while loop: its number of passes must come from the integers",
                 c_ast.DoWhile: "a do loop: its number of passes must come from the integers",
                 c_ast.Goto: "goto", c_ast.Label: "a label", c_ast.Break: "break out of a loop",
                 c_ast.Continue: "continue", c_ast.ExprList: "the comma operator"}
        self.refuse(node, words.get(type(node), f"a statement that has no effect or is unknown "
                                                f"({type(node).__name__})"))

    def assignment(self, node, where, comment):
        if not isinstance(node.lvalue, (c_ast.ID, c_ast.ArrayRef)):
            self.refuse(node, "an assignment to what is neither a variable nor an array element")
        target = self.expr(node.lvalue)
        value = self.expr(node.rvalue)
        if target.name in self.globals:
            self.refuse(node, f"`{target.name}` is a variable outside of functions")
        if "->" in target.name:
            self.refuse(node, f"`{target.name}` is changed: the integers are passive")
        p = self.parameter_of(target.name)
        if p and p.const:
            self.refuse(node, f"`{target.name}` is const")
        if node.op in ("=", "+=", "-="):
            return Assign(where, comment, target, node.op, value)
        if node.op in ("*=", "/="):
            if isinstance(target, Ref) and p:
                self.refuse(node, f"`{target.name}` is overwritten: {node.op} on an array element")
            return Assign(where, comment, target, "=", Bin(node.op[0], target, value))
        self.refuse(node, f"the operator {node.op}")

    def loop(self, node, where, comment):
        self.scopes.append({})
        out = self.counted(node, where, comment)
        self.scopes.pop()
        return [out]

    def counted(self, node, where, comment):
        start = node.init
        if isinstance(start, c_ast.DeclList):
            if len(start.decls) != 1 or start.decls[0].init is None:
                self.refuse(node, "a for loop that is not `for (i = a; i < b; ++i)`")
            d = start.decls[0]
            var, first = d.name, self.expr(d.init)
            d.init = None
            self.local(d)
        elif isinstance(start, c_ast.Assignment) and start.op == "=" and \
                isinstance(start.lvalue, c_ast.ID):
            var, first = start.lvalue.name, self.expr(start.rvalue)
        else:
            self.refuse(node, "a for loop that is not `for (i = a; i < b; ++i)`")
        test = node.cond
        if not (isinstance(test, c_ast.BinaryOp) and test.op in ("<", "<=", ">", ">=")
                and isinstance(test.left, c_ast.ID) and test.left.name == var):
            self.refuse(node, "a for loop that is not `for (i = a; i < b; ++i)`")
        bound, step = self.expr(test.right), self.step(node.next, var)
        var = self.visible(var)
        if step is None or (step > 0) != (test.op in ("<", "<=")):
            self.refuse(node, "a for loop that is not `for (i = a; i < b; ++i)`")
        if self.f.locals.get(var, ("",))[0] != "int":
            self.refuse(node, f"the loop variable `{var}` is not a local int")
        body = self.body(node.stmt)
        changed = ir.all_writes(body)
        if var in changed:
            self.refuse(node, f"the loop variable `{var}` is changed in the loop")
        for name in ir.names(bound):
            if name in changed and "->" not in name:
                self.refuse(node, f"the loop bound `{name}` is changed in the loop")
        return For(where, comment, var, first, test.op, bound, step, body)

    def step(self, node, var):
        if isinstance(node, c_ast.UnaryOp) and isinstance(node.expr, c_ast.ID) and \
                node.expr.name == var:
            return {"++": 1, "p++": 1, "--": -1, "p--": -1}.get(node.op)
        if isinstance(node, c_ast.Assignment) and isinstance(node.lvalue, c_ast.ID) and \
                node.lvalue.name == var and node.op in ("+=", "-="):
            n = ir.integer(fold(self.expr(node.rvalue), self.program.enumerators))
            if n:
                return n if node.op == "+=" else -n
        return None

    def switch(self, node, where, comment):
        what = self.expr(node.cond)
        groups, labels = [], []  # (labels, statements)
        items = node.stmt.block_items if isinstance(node.stmt, c_ast.Compound) else [node.stmt]
        for item in items:
            if not isinstance(item, (c_ast.Case, c_ast.Default)):
                self.refuse(item, "a switch whose statements are not under its cases")
            labels.append(self.expr(item.expr) if isinstance(item, c_ast.Case) else None)
            stmts = list(item.stmts or [])
            while len(stmts) == 1 and isinstance(stmts[0], c_ast.Compound):
                stmts = list(stmts[0].block_items or [])
            if not stmts:
                continue
            if isinstance(stmts[-1], c_ast.Break):
                stmts.pop()
            elif item is not items[-1]:
                self.refuse(item, "a case that falls through")
            groups.append((labels, self.block(stmts)))
            labels = []
        default, cases = [], []
        for labels, stmts in groups:
            if None in labels:
                default = stmts
            else:
                test = None
                for label in labels:
                    one = Bin("==", what, label)
                    test = one if test is None else Bin("||", test, one)
                cases.append((test, stmts))
        out = default
        for test, stmts in reversed(cases):
            out = [If(where, (), test, stmts, out)]
        if not cases:
            return If(where, comment, Num("1"), default, [])
        out[0].comment = comment
        return out[0]

    # ------------------------------------------------------------------------------- expressions

    def callee(self, node):
        if not isinstance(node.name, c_ast.ID):
            self.refuse(node, "a call through a pointer")
        if self.parameter_of(node.name.name):
            self.refuse(node, f"`{node.name.name}` is a pointer to a function")
        return node.name.name

    def arguments(self, node):
        return tuple(self.expr(a) for a in (node.args.exprs if node.args else ()))

    def expr(self, node):
        if isinstance(node, c_ast.Constant):
            if node.type in ("int", "double", "float", "long int", "unsigned int"):
                return Num(node.value)
            self.refuse(node, f"the constant {node.value}")
        if isinstance(node, c_ast.ID):
            if node.name in self.globals:
                self.refuse(node, f"`{node.name}` is a variable outside of functions")
            return Var(self.visible(node.name))
        if isinstance(node, c_ast.StructRef):
            if node.type == "->" and isinstance(node.name, c_ast.ID):
                return Var(f"{node.name.name}->{node.field.name}")
            self.refuse(node, "a member of a structure")
        if isinstance(node, c_ast.ArrayRef):
            base, index = node, []
            while isinstance(base, c_ast.ArrayRef):
                index.insert(0, self.expr(base.subscript))
                base = base.name
            b = self.expr(base)
            if not isinstance(b, Var):
                self.refuse(node, "an element of what is not an array")
            return Ref(b.name, tuple(index))
        if isinstance(node, c_ast.UnaryOp):
            if node.op in ("++", "--", "p++", "p--"):
                self.refuse(node, f"a side effect in an expression ({node.op.lstrip('p')})")
            if node.op == "&":
                self.refuse(node, "an interior pointer: pass a row of a two-dimensional array, or "
                                  "the array and an index")
            if node.op == "*":
                self.refuse(node, "a pointer is followed")
            if node.op == "sizeof":
                self.refuse(node, "sizeof")
            a = self.expr(node.expr)
            return a if node.op == "+" else Un(node.op, a)
        if isinstance(node, c_ast.BinaryOp):
            a, b = self.expr(node.left), self.expr(node.right)
            for x in (a, b):
                if isinstance(x, Var) and self.f:
                    p, local = self.parameter_of(x.name), self.f.locals.get(x.name)
                    if (p and p.kind in ("array", "ints", "topo")) or (local and local[1]):
                        self.refuse(node, f"an interior pointer: `{x.name}` in an expression; pass "
                                          f"a row of a two-dimensional array, or the array and an "
                                          f"index")
            return Bin(node.op, a, b)
        if isinstance(node, c_ast.TernaryOp):
            return Cond(self.expr(node.cond), self.expr(node.iftrue), self.expr(node.iffalse))
        if isinstance(node, c_ast.FuncCall):
            return Call(self.callee(node), self.arguments(node))
        if isinstance(node, c_ast.Cast):
            base, _ = self.base_type(node.to_type.type)
            if base in ("double", "int"):
                return Call(f"({base})", (self.expr(node.expr),))
            self.refuse(node, f"a conversion to {base or 'a pointer'}")
        if isinstance(node, c_ast.Assignment):
            self.refuse(node, "a side effect in an expression (an assignment)")
        if isinstance(node, c_ast.ExprList):
            self.refuse(node, "the comma operator")
        self.refuse(node, f"an expression that the subset does not know ({type(node).__name__})")
