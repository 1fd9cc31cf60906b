"""Random programs in the subset of C that the engine reads.

A program is one head with its helpers: a sequence of phases, each of which computes something from
what is there (locals, tree recursions, sums over edges, chains), in the manner of core/kernel.
Values stay of moderate size: every value carries a bound, and what may grow is squashed.
"""

import random

NP = 8  # parameters that every structure has
NAMES = ("n", "np", "ne")

HEADER = """\
#ifndef KERNEL_H
#define KERNEL_H

#include <math.h>

#ifndef MAGGI_RE
#define MAGGI_RE(x) (x)
#endif

typedef struct topo {
  int n;       /* bodies; the ground is row n */
  int np;      /* parameters */
  int ne;      /* edges */
  int *parent; /* of a body, larger than it, at most n */
  int *kind;   /* 0 .. 3 */
  int *perm;   /* permutation of the bodies */
  int *adr;    /* three parameters from here */
  int *count;  /* 0 .. 3 */
  int *first;  /* first edge of a body, n + 1 */
  int *from;   /* rows */
  int *to;
} topo;

enum { KIND_ZERO, KIND_ONE, KIND_TWO, KIND_THREE = KIND_TWO + 1 };

#endif
"""

STRUCTURES = [
    "{3, 8, 4, (int[]){2, 2, 3}, (int[]){0, 2, 1}, (int[]){1, 2, 0}, (int[]){0, 5, 2}, "
    "(int[]){3, 0, 2}, (int[]){0, 1, 1, 4}, (int[]){0, 1, 3, 2}, (int[]){2, 2, 0, 1}}",
    "{4, 9, 5, (int[]){1, 3, 4, 4}, (int[]){1, 0, 3, 2}, (int[]){3, 1, 0, 2}, (int[]){6, 0, 3, 1}, "
    "(int[]){1, 3, 2, 0}, (int[]){0, 2, 2, 3, 5}, (int[]){0, 4, 1, 2, 3}, (int[]){3, 0, 2, 2, 1}}",
]

CHOICE, SUM, PRODUCT, SIGN, ATOM = range(5)  # how tightly the text of a value binds


class Value:
    """An expression: its text, a bound of its size, and how tightly it binds."""

    def __init__(self, text, bound, level=ATOM):
        self.text, self.bound, self.level = text, bound, level

    def at(self, level):
        return self.text if self.level >= level else f"({self.text})"


class Helper:
    """A function that others may call."""

    def __init__(self, name, kind, parameters, bound):
        self.name, self.kind, self.parameters, self.bound = name, kind, parameters, bound


class Function:
    """Writes one function; what is declared, assigned and readable at the place it has reached."""

    def __init__(self, rng, name, helpers):
        self.rng, self.name, self.helpers = rng, name, helpers
        self.lines, self.depth, self.loops = [], 1, 0
        self.doubles, self.integers, self.arrays = set(), set(), {}
        self.scalars = {}  # readable doubles: name -> bound
        self.vectors = {}  # readable arrays of three, rows included: text -> bound
        self.counters = {}  # integers: name -> body, row, edge, three
        self.parameters = None  # name and bound of p
        self.coordinates = {}  # readable arrays of n: name -> bound
        self.tables = {}  # readable arrays of n + 1 rows: name -> bound
        self.has_topo = False
        # local arrays: either a name is used again, or indices may vary (the engine takes no both)
        self.again = rng.random() < 0.5
        self.ties = []  # texts of inputs, one of which every written element gets

    # ------------------------------------------------------------------------------------- text

    def line(self, text):
        self.lines.append("  " * self.depth + text)

    def text(self, signature):
        out = [signature, "{"]
        declared = [
            ("int", sorted(self.integers)),
            ("double", sorted(self.doubles)),
            ("double", [f"{a}[{n}]" for a, n in sorted(self.arrays.items())]),
        ]
        out += [f"  {kind} {', '.join(names)};" for kind, names in declared if names]
        return "\n".join([*out, "", *self.lines, "}", ""])

    def chance(self, p):
        return self.rng.random() < p

    def pick(self, items):
        return self.rng.choice(list(items))

    def open(self, text):
        """A block: what is assigned in it is forgotten when it closes."""
        self.line(text + " {")
        self.depth += 1
        return dict(self.scalars), dict(self.vectors), dict(self.counters)

    def close(self, saved, text="}"):
        self.depth -= 1
        self.line(text)
        now = self.scalars, self.vectors
        scalars, vectors, self.counters = saved
        self.scalars = {name: max(bound, now[0][name]) for name, bound in scalars.items()}
        self.vectors = vectors
        return now

    # ----------------------------------------------------------------------------------- values

    def of(self, kind):
        return [name for name, k in self.counters.items() if k == kind]

    def component(self):
        k = self.of("three")
        if k and self.chance(0.7):
            name = self.pick(k)
            return self.pick([name, name, name, f"({name} + 1) % 3", f"2 - {name}"])
        small = self.of("small")
        if small and not self.again and self.chance(0.3):
            return self.pick(small)
        return str(self.rng.randrange(3))

    def body(self):
        names = self.of("body")
        if names and self.chance(0.85):
            name = self.pick(names)
            return self.pick([name, name, f"t->perm[{name}]"])
        return self.pick(["0", "1", "2", "t->n - 1"])

    def row(self):
        found = list(self.of("row"))
        for name in self.of("body"):
            found += [name, f"t->parent[{name}]"]
        for name in self.of("edge"):
            found += [f"t->from[{name}]", f"t->to[{name}]"]
        if found and self.chance(0.85):
            return self.pick(found)
        return self.pick(["0", "t->n", "2"])

    def integer(self):
        """An integer of small size."""
        found = ["2", "3"]
        for name in self.of("three"):
            found += [name, f"{name} + 1", f"2 * {name} - 1", f"{name} / 2", f"{name} % 2"]
        for name in self.of("body"):
            if self.has_topo:
                found += [f"t->kind[{name}]", f"t->kind[{name}] + 1", f"t->kind[{name}] / 2"]
            found += [f"{name} - 1"]
        for name in self.of("small"):
            found += [name, name, f"{name} - 1"]
        text = self.pick(found)
        level = ATOM
        if " + " in text or " - " in text:
            level = SUM
        elif " / " in text or " % " in text:
            level = PRODUCT
        return Value(text, 7.0, level)

    def number(self):
        text = self.pick(["0.5", "2.0", "1.5", "0.25", "1.0", "3.0", "0.75", "-0.5", "2", "1e-1"])
        return Value(text, abs(float(text)), SIGN if text[0] == "-" else ATOM)

    def vector(self):
        """Text and bound of an array of three that a call can take, or None."""
        found = list(self.vectors.items())
        for name, bound in self.tables.items():
            found.append((f"{name}[{self.row()}]", bound))
        return self.pick(found) if found else None

    def tied(self, v):
        """v, and in heads a part that depends on an input for sure"""
        if not self.ties:
            return v.text
        text = {
            "p": f"p[{self.rng.randrange(NP)}]",
            "q": f"q[{self.body()}]",
            "s": "s",
            "X": f"X[{self.row()}][{self.component()}]",
        }[self.pick(self.ties)]
        return f"{v.at(SUM)} + {self.pick(['0.5 * ', '0.125 * ', ''])}{text}"

    def leaf(self):
        found = []
        found += [Value(name, bound) for name, bound in self.scalars.items()] * 2
        for name, bound in self.vectors.items():
            found.append(Value(f"{name}[{self.component()}]", bound))
        for name, bound in self.tables.items():
            found += [Value(f"{name}[{self.row()}][{self.component()}]", bound)] * 2
        for name, bound in self.coordinates.items():
            found += [Value(f"{name}[{self.body()}]", bound)] * 2
        if self.parameters:
            name, bound = self.parameters
            index = [str(self.rng.randrange(NP))]
            index += [f"t->adr[{i}] + {self.component()}" for i in self.of("body") if self.has_topo]
            index += [f"{a} + {self.component()}" for a in self.of("address")]
            found += [Value(f"{name}[{self.pick(index)}]", bound)] * 2
        if not found or self.chance(0.08):
            return self.number()
        return self.pick(found)

    def call_value(self):
        """A call of a helper with a value, or None."""
        helpers = [h for h in self.helpers if h.kind == "double"]
        if not helpers:
            return None
        helper = self.pick(helpers)
        arguments = self.call_arguments(helper)
        return Value(f"{helper.name}({', '.join(arguments)})", helper.bound) if arguments else None

    def call_arguments(self, helper, output=None):
        arguments = []
        for parameter in helper.parameters:
            if parameter == "double":
                arguments.append(self.value(1, 4.0).text)
            elif parameter == "vector":
                vector = self.vector()
                if not vector or vector[1] > 8.0:
                    return None
                arguments.append(vector[0])
            elif parameter == "three":
                k = self.of("three")
                arguments.append(
                    self.pick(k) if k and self.chance(0.6) else str(self.rng.randrange(3))
                )
            elif parameter == "parameters":
                if not self.parameters or not self.has_topo:
                    return None
                body = self.of("body")
                address = f"t->adr[{self.pick(body)}]" if body else str(self.rng.randrange(NP - 3))
                arguments += ["t->np", self.parameters[0], address]
            else:
                arguments.append(output)
        return arguments

    def expression(self, depth):
        if depth == 0 or self.chance(0.1):
            return self.leaf()
        kind = self.rng.randrange(20)
        if kind < 4:
            a, b = self.expression(depth - 1), self.expression(depth - 1)
            if self.chance(0.5):
                return Value(f"{a.at(SUM)} + {b.at(PRODUCT)}", a.bound + b.bound, SUM)
            return Value(f"{a.at(SUM)} - {b.at(PRODUCT)}", a.bound + b.bound, SUM)
        if kind < 8:
            a, b = self.small(depth - 1), self.small(depth - 1)
            return Value(f"{a.at(PRODUCT)} * {b.at(SIGN)}", a.bound * b.bound, PRODUCT)
        if kind == 8:
            a, b = self.small(depth - 1), self.positive(depth - 1)
            return Value(f"{a.at(PRODUCT)} / {b.at(SIGN)}", a.bound, PRODUCT)
        if kind == 9:
            a = self.expression(depth - 1)
            form = self.pick(["-{}", "-{}", "-{}", "(double){}"])
            return Value(form.format(a.at(ATOM)), a.bound, SIGN)
        if kind == 10:
            a, k = self.small(depth - 1), self.integer()
            form = self.pick(["{a} * {k}", "{k} * {a}", "{a} / ({k} + 9)", "{k} * ({k} - 1) * {a}"])
            return Value(
                form.format(a=a.at(SIGN), k=k.at(ATOM if form[0] == "{" else SUM)),
                56.0 * a.bound,
                PRODUCT,
            )
        if kind == 11:
            value = self.call_value()
            return value or self.leaf()
        if kind == 12:
            a, b = self.expression(depth - 1), self.expression(depth - 1)
            condition = self.condition()
            return Value(
                f"{condition} ? {a.at(SUM)} : {b.at(CHOICE)}", max(a.bound, b.bound), CHOICE
            )
        return self.elementary(depth - 1)

    def elementary(self, depth):
        a = self.small(depth)
        kind = self.rng.randrange(17)
        x = a.text
        if kind == 0:
            return Value(f"sin({x})", 1.0)
        if kind == 1:
            return Value(f"cos({x})", 1.0)
        if kind == 2:
            return Value(f"tan(sin({x}))", 1.6)
        if kind == 3:
            return Value(f"asin(0.8 * sin({x}))", 1.0)
        if kind == 4:
            return Value(f"acos(0.75 * cos({x}))", 2.5)
        if kind == 5:
            return Value(f"atan({x})", 1.6)
        if kind == 6:
            b = self.small(depth)
            return Value(f"atan2({x}, 1.5 + cos({b.text}))", 1.6)
        if kind == 7:
            return Value(f"sinh(sin({x}))", 1.2)
        if kind == 8:
            return Value(f"cosh(cos({x}))", 1.6)
        if kind == 9:
            return Value(f"tanh({x})", 1.0)
        if kind == 10:
            return Value(f"exp(sin({x}))", 2.8)
        if kind == 11:
            return Value(f"log({self.positive(depth).text})", 2.5)
        if kind == 12:
            b = self.positive(depth)
            return Value(f"sqrt({b.text})", b.bound**0.5)
        if kind == 13:
            b = self.leaf()
            return Value(f"pow({self.positive(depth).text}, sin({b.text}))", 12.0)
        if kind == 14:
            n = self.pick(["2", "3", "2.0", "1.5", "0.5", "-1.0", "-2"])
            base = self.positive(depth) if "." in n and n != "2.0" or "-" in n else a
            if base is a and a.bound > 2.0:
                base = Value(f"sin({a.text})", 1.0)
            return Value(f"pow({base.text}, {n})", max(1.0, base.bound) ** max(float(n), 0.0))
        if kind == 15:
            k = self.of("three")
            if k:  # an integer exponent
                return Value(f"pow(cos({x}), {self.pick(k)} + 1)", 1.0)
        return Value(f"fabs({x})", a.bound)

    def small(self, depth, bound=4.0):
        """An expression of at most this size."""
        return self.squash(self.expression(depth), bound)

    def squash(self, v, bound):
        if v.bound <= bound:
            return v
        kind = self.rng.randrange(5)
        if kind == 0 and v.level == ATOM and len(v.text) < 24:
            return Value(f"{v.text} / sqrt(1.0 + {v.text} * {v.text})", 1.0, PRODUCT)
        if kind == 1:
            return Value(f"tanh(0.25 * {v.at(SIGN)})", 1.0)
        return Value(self.pick(["sin({})", "cos({})", "sin(0.5 * ({}))"]).format(v.text), 1.0)

    def positive(self, depth):
        """An expression between 1/2 and about 12."""
        v = self.small(depth, 3.0)
        kind = self.rng.randrange(3)
        if kind == 0 or len(v.text) > 40:
            return Value(f"1.5 + cos({v.text})", 2.5, SUM)
        if kind == 1:
            return Value(f"0.5 + {v.at(PRODUCT)} * {v.at(SIGN)}", 9.5, SUM)
        return Value(f"exp(0.6 * sin({v.text}))", 1.9)

    def value(self, depth=None, bound=None):
        v = self.expression(self.rng.choice([0, 1, 1, 2, 2, 3]) if depth is None else depth)
        return v if bound is None else self.squash(v, bound)

    # ------------------------------------------------------------------------------- conditions

    def passive_condition(self):
        found = []
        for name in self.of("three"):
            found += [
                f"{name} == 1",
                f"{name} < 2",
                f"{name} % 2 == 0",
                f"!({name} == 2)",
                f"{name} != 0 && {name} < 2",
            ]
        for name in self.of("body"):
            found += [f"{name} > 0", f"{name} % 2 == 1"]
            if self.has_topo:
                found += [
                    f"t->kind[{name}] == 1",
                    f"t->kind[{name}] >= 2",
                    f"t->kind[{name}]",
                    f"t->parent[{name}] == t->n || t->kind[{name}] == 0",
                ]
        for name in self.of("edge"):
            found += [f"t->from[{name}] < t->to[{name}]"]
        for name in self.of("small"):
            found += [f"{name} > 0", f"{name} == 1"]
        return self.pick(found) if found else None

    def active_condition(self):
        a = self.value(1).text
        b = self.pick(["0.0", "0.25", "-0.5", self.value(1).text])
        return f"MAGGI_RE({a}) {self.pick(['<', '>', '<=', '>='])} MAGGI_RE({b})"

    def condition(self):
        passive = self.passive_condition()
        kind = self.rng.randrange(6)
        if passive and kind < 3:
            return passive
        if passive and kind == 3:
            return f"({passive}) {self.pick(['&&', '||'])} {self.active_condition()}"
        return self.active_condition()

    # ------------------------------------------------------------------------------- statements

    def block(self, count, depth):
        for _ in range(count):
            self.statement(depth)

    def statement(self, depth):
        kinds = ["assign"] * 5 + ["update"] * 4 + ["fill"] * 3
        if depth > 0:
            kinds += ["branch"] * 3 + ["switch"] + ["loop"] * 3
        if self.helpers:
            kinds += ["choose"]
        getattr(self, self.pick(kinds))(depth)

    def assign(self, depth):
        name = f"d{self.rng.randrange(5)}"
        v = self.value(bound=2.0)
        self.doubles.add(name)
        self.line(f"{name} = {v.text};")
        self.scalars[name] = 2.0 if self.loops else v.bound

    def update(self, depth):
        own = [name for name in self.scalars if name in self.doubles]
        if not own:
            self.assign(depth)
            return
        name = self.pick(own)
        op = self.pick(["+=", "+=", "-=", "*=", "=", "=", "/=", "own"])
        if op == "own":  # a sum that reads what it adds to
            op = self.pick(["+=", "-="])
            v = Value(
                self.pick(["0.5 * sin({x})", "0.25 * tanh({x}) * {o}", "{o} * cos({x})"]).format(
                    x=name, o=self.small(1, 1.0).at(SIGN)
                ),
                1.0,
            )
            self.scalars[name] += 18.0 if self.loops else 1.0
        elif op in ("+=", "-="):
            v = self.value(bound=1.0 if self.loops else 3.0)
            self.scalars[name] += 18.0 if self.loops else v.bound
        elif op == "*=":
            v = self.value(bound=1.0)
        elif op == "/=":
            v = Value(f"1.25 + sin({self.value(1).text})", 1.0, SUM)
            if self.loops:
                v = Value(f"2.25 + sin({self.value(1).text})", 1.0, SUM)
            else:
                self.scalars[name] *= 4.0
        else:  # contracts, that loops do not make chaos
            other = self.small(1, 2.0)
            v = Value(
                self.pick(
                    [
                        "0.5 * {x} + 0.25 * {o}",
                        "sin({x}) * 0.5 + {o} * 0.5",
                        "0.5 * ({x} - {o})",
                        "0.7 * cos({x}) * {o}",
                        "{x} > 0.0 ? 0.5 * {x} : -0.25 * {x}",
                    ]
                )
                .format(x=name, o=other.at(SIGN))
                .replace(f"{name} > 0.0", f"MAGGI_RE({name}) > 0.0"),
                2.0,
            )
            self.scalars[name] = max(2.0, 0.5 * self.scalars[name] + 1.0)
        self.line(f"{name} {op} {v.text};")

    def branch(self, depth):
        saved = self.open(f"if ({self.condition()})")
        self.block(self.rng.randint(1, 2), depth - 1)
        if self.chance(0.6):
            then = self.close(saved, "} else {")
            self.depth += 1
            start = dict(self.scalars), dict(self.vectors), dict(self.counters)
            self.block(self.rng.randint(1, 2), depth - 1)
            other = self.close(start)
            self.scalars.update(
                {
                    name: max(bound, other[0][name])
                    for name, bound in then[0].items()
                    if name in other[0]
                }
            )
            self.vectors.update(
                {
                    name: max(bound, other[1][name])
                    for name, bound in then[1].items()
                    if name in other[1]
                }
            )
        else:
            self.close(saved)

    def switch(self, depth):
        found = [f"t->kind[{i}]" for i in self.of("body") if self.has_topo]
        found += [*self.of("three"), *(f"{i} % 3" for i in self.of("body")), *self.of("small")]
        if not found:
            self.branch(depth)
            return
        saved = self.open(f"switch ({self.pick(found)})")
        for label in self.rng.sample(["case 0:", "case 1:", "case 2:"], self.rng.randint(1, 3)) + [
            "default:"
        ] * self.chance(0.7):
            state = dict(self.scalars), dict(self.vectors), dict(self.counters)
            self.line(label)
            self.depth += 1
            self.block(self.rng.randint(1, 2), 0)
            self.line("break;")
            self.close(state, "")
            self.lines.pop()
        self.close(saved)

    def counter(self):
        name = next(c for c in "ijklmnab" if c not in self.counters)
        self.integers.add(name)
        return name

    def header(self, what=None):
        """Text of a loop over something, its counter and what the counter is."""
        name = self.counter()
        up, down = (
            f"for ({name} = {{a}}; {name} < {{b}}; ++{name})",
            f"for ({name} = {{b}} - 1; {name} >= {{a}}; --{name})",
        )
        form = up if self.chance(0.7) else down
        if what is None:
            what = self.pick(["three"] * 3 + (["body", "edge", "some"] if self.has_topo else []))
        if what == "three":
            odd = [
                f"for ({name} = 0; {name} <= 2; {name} += 2)",
                f"for ({name} = 2; {name} > 0; {name}--)",
            ]
            counts = [f"t->count[{i}]" for i in self.of("body") if self.has_topo]
            text = form.format(a="0", b="3")
            if counts and not self.again and self.chance(0.3):
                text = form.format(a="0", b=self.pick(counts))
            elif self.chance(0.15):
                text = self.pick(odd)
        elif what == "all three":
            what, text = "three", form.format(a="0", b="3")
        elif what == "body":
            others = self.of("body")
            text = form.format(a="0", b="t->n")
            if others and self.chance(0.4):
                text = form.format(a="0", b=self.pick(others))
        elif what == "all bodies":
            what, text = "body", form.format(a="0", b="t->n")
        elif what == "row":
            text = self.pick(
                [
                    f"for ({name} = 0; {name} <= t->n; ++{name})",
                    f"for ({name} = t->n; {name} >= 0; --{name})",
                ]
            )
        elif what == "some" and self.of("body"):
            i = self.pick(self.of("body"))
            what, text = "edge", form.format(a=f"t->first[{i}]", b=f"t->first[{i} + 1]")
        else:
            what, text = "edge", form.format(a="0", b="t->ne")
        return text, name, what

    def loop(self, depth, what=None):
        text, name, kind = self.header(what)
        saved = self.open(text)
        self.counters[name] = kind
        self.loops += 1
        self.block(self.rng.randint(1, 2), depth - 1)
        self.loops -= 1
        self.close(saved)

    def choose(self, depth):
        """An integer local, from the integers or by comparison of active values."""
        name = f"c{self.rng.randrange(2)}"
        helpers = [h for h in self.helpers if h.kind == "int"]
        if name in self.counters or not helpers or self.chance(0.3):
            address = [f"t->adr[{i}]" for i in self.of("body") if self.has_topo]
            if address and "c2" not in self.counters:
                self.integers.add("c2")
                self.line(f"c2 = {self.pick(address)};")
                self.counters["c2"] = "address"
                return
            self.assign(depth)
            return
        helper = self.pick(helpers)
        arguments = self.call_arguments(helper)
        if arguments:
            self.integers.add(name)
            self.line(f"{name} = {helper.name}({', '.join(arguments)});")
            self.counters[name] = "small"

    # ----------------------------------------------------------------------------- local arrays

    def fill(self, depth):
        """A local array of three, written once in this block, then perhaps added to."""
        names = [f"w{k}" for k in range(6 if self.again else len(self.arrays) + 1)]
        free = [x for x in names if x not in (self.vectors if self.again else self.arrays)]
        if not free:
            self.assign(depth)
            return
        name = self.pick(free)
        self.arrays[name] = 3
        kind = self.rng.randrange(5)
        helpers = [h for h in self.helpers if h.kind == "void"]
        if kind == 0 and helpers:
            helper = self.pick(helpers)
            arguments = self.call_arguments(helper, name)
            if arguments:
                self.line(f"{helper.name}({', '.join(arguments)});")
                self.vectors[name] = helper.bound
                return
        bound = 2.0
        if kind == 1:
            for k in range(3):
                self.line(f"{name}[{k}] = {self.value(2, 2.0).text};")
                if self.chance(0.3):
                    self.scalars[f"{name}[{k}]"] = 2.0
            for k in range(3):
                self.scalars.pop(f"{name}[{k}]", None)
        else:
            self.write_three(lambda k, v: f"{name}[{k}] = {v};", 2.0)
            if self.chance(0.4):
                self.add_three(name)
                bound = 20.0
        self.vectors[name] = bound

    def write_three(self, form, bound, text=lambda v: v.text):
        """for all k, or one after the other, form(k, value); a branch in between now and then."""
        if self.chance(0.3):
            for k in range(3):
                self.line(form(str(k), text(self.value(bound=bound))))
            return
        loop, k, kind = self.header("all three")
        saved = self.open(loop)
        self.counters[k] = kind
        self.loops += 1
        if self.chance(0.3):
            self.statement(0)
        if self.chance(0.3):
            self.line(f"if ({self.condition()})")
            self.line("  " + form(k, text(self.value(bound=bound))))
            self.line("else")
            self.line("  " + form(k, text(self.value(bound=bound))))
        else:
            self.line(form(k, text(self.value(bound=bound))))
        self.loops -= 1
        self.close(saved)

    def add_three(self, name, bound=1.0):
        """name[k] += ..; name is not readable yet"""
        adders = [h for h in self.helpers if h.kind == "add"]
        if adders and self.chance(0.5):
            helper = self.pick(adders)
            arguments = self.call_arguments(helper, name)
            if arguments:
                self.line(f"{helper.name}({', '.join(arguments)});")
                return
        outer = None
        if self.has_topo and self.chance(0.4):
            text, e, kind = self.header("edge")
            outer = self.open(text)
            self.counters[e] = kind
            self.loops += 1
        text, k, kind = self.header("three")
        saved = self.open(text)
        self.counters[k] = kind
        self.loops += 1
        self.line(f"{name}[{k}] {self.pick(['+=', '-='])} {self.value(bound=bound).text};")
        self.loops -= 1
        self.close(saved)
        if outer:
            self.loops -= 1
            self.close(outer)


class Program:
    """name, text in C, and arguments of one head."""

    def __init__(self, seed):
        self.seed = seed
        self.rng = random.Random(seed)
        self.name = f"p{seed}"
        self.size = 2 if self.rng.random() < 0.1 else 1
        self.helpers, texts = [], []
        for k in range(self.rng.randint(1, 2 * self.size)):
            texts.append(self.helper(f"{self.name}_h{k}"))
        texts.append(self.head())
        self.text = "\n".join(texts)

    # ---------------------------------------------------------------------------------- helpers

    def helper(self, name):
        kind = self.rng.choice(["double", "double", "void", "void", "add", "int", "fetch", "whole"])
        f = Function(self.rng, name, list(self.helpers))
        if kind == "int":
            f.scalars, f.vectors = {"x": 4.0}, {"u": 8.0}
            f.line(f"if ({f.active_condition()}) return 2;")
            if f.chance(0.5):
                f.integers.add("k")
                f.line("for (k = 0; k < 2; ++k)")
                f.line("  if (MAGGI_RE(x) < MAGGI_RE(u[k + 1])) return k;")
            f.line("return 1;")
            parameters = ["double", "vector"]
            signature = f"static int {name}(double x, const double u[3])"
        elif kind == "double":
            f.scalars, f.vectors = {"x": 4.0, "z": 4.0}, {"u": 8.0}
            f.counters["k"] = "three"
            f.block(self.rng.randint(0, 3), self.rng.randint(0, 1))
            f.line(f"return {f.value(bound=3.0).text};")
            parameters = ["double", "vector", "three", "double"]
            signature = f"static double {name}(double x, const double u[3], int k, double z)"
        elif kind == "whole":
            f.has_topo = True
            f.scalars, f.tables = {"x": 4.0}, {"A": 1.5}
            f.counters["m"] = "row"
            f.block(self.rng.randint(0, 2), 1)
            f.write_three(lambda k, v: f"B[m][{k}] = {v};", 3.0)
            parameters = []
            signature = (
                f"static void {name}(const topo *t, int m, const double A[t->n + 1][3], "
                "double x, double B[t->n + 1][3])"
            )
        elif kind == "fetch":
            f.parameters = ("p", 1.5)
            f.counters["adr"] = "address"
            f.block(self.rng.randint(0, 2), 0)
            f.write_three(lambda k, v: f"c[{k}] = {v};", 3.0)
            parameters, kind = ["parameters", "output"], "void"
            signature = f"static void {name}(int np, const double p[np], int adr, double c[3])"
        else:
            f.scalars, f.vectors = {"x": 4.0}, {"u": 8.0, "v": 8.0}
            f.block(self.rng.randint(0, 3), self.rng.randint(0, 1))
            op = "=" if kind == "void" else self.rng.choice(["+=", "-="])
            f.write_three(lambda k, v: f"c[{k}] {op} {v};", 3.0 if kind == "void" else 1.0)
            if kind == "void" and f.chance(0.2):
                f.add_three("c")
            parameters = ["vector", "double", "vector", "output"]
            signature = (
                f"static void {name}(const double u[3], double x, const double v[3], "
                "double c[3])"
            )
        self.helpers.append(Helper(name, kind, parameters, 3.0 if kind != "void" else 8.0))
        return f.text(signature)

    # ------------------------------------------------------------------------------------- head

    def head(self):
        """Phases; outputs are y, z, Y, V, e, and F, which is accumulated."""
        f = self.f = Function(self.rng, self.name, self.helpers)
        f.has_topo = True
        f.parameters = ("p", 1.5)
        f.scalars = {"s": 1.5}
        f.coordinates = {"q": 1.5}
        f.tables = {"X": 1.5}
        self.inputs = f.ties = self.rng.sample(["p", "q", "X", "s"], self.rng.randint(1, 4))
        phases = ["locals", "workspace", "coordinates", "chain", "tree", "edges", "energy", "add"]
        self.outputs = []
        for phase in self.rng.sample(phases, self.rng.randint(self.size, 2 * self.size)):
            getattr(self, "phase_" + phase)()
        if not self.outputs:
            self.phase_coordinates()
        both = [name for name in self.outputs if name == "F"]
        shapes = {
            "y": "t->n",
            "z": "t->n",
            "Y": "t->n + 1][3",
            "V": "t->n + 1][3",
            "e": "1",
            "F": "t->n + 1][3",
        }
        arguments = [
            "const double p[t->np]",
            "const double q[t->n]",
            "const double X[t->n + 1][3]",
            "double s",
        ]
        arguments += [f"double {name}[{shapes[name]}]" for name in self.outputs]
        self.inputs = self.inputs + both
        self.signature = f"void {self.name}(const topo *t, {', '.join(arguments)})"
        return f.text(self.signature)

    def phase_locals(self):
        """locals that later phases read"""
        self.f.block(self.rng.randint(2, 3), self.size)

    def inside(self, what):
        f = self.f
        text, name, kind = f.header(what)
        saved = f.open(text)
        f.counters[name] = kind
        f.loops += 1
        return name, saved

    def outside(self, saved):
        self.f.loops -= 1
        self.f.close(saved)

    def write(self, element, bound=3.0):
        """element = .., perhaps in both branches, perhaps added to"""
        f = self.f
        kind = f.rng.randrange(4)
        if kind == 0:
            f.line(f"if ({f.condition()})")
            f.line(f"  {element} = {f.tied(f.value(bound=bound))};")
            f.line("else")
            f.line(f"  {element} = {f.value(bound=bound).text};")
        else:
            f.line(f"{element} = {f.tied(f.value(bound=bound))};")
        if f.chance(0.3):
            f.line(f"{element} {f.pick(['+=', '-='])} {f.value(bound=bound).text};")
        if f.chance(0.2):
            f.line(f"if ({f.condition()}) {element} += {f.value(bound=bound).text};")

    def phase_coordinates(self):
        """y, in any order of the bodies; now and then even and odd ones apart"""
        f = self.f
        if f.chance(0.25):
            for start in (0, 1):
                i = f.counter()
                saved = f.open(f"for ({i} = {start}; {i} < t->n; {i} += 2)")
                f.counters[i] = "body"
                f.loops += 1
                f.block(f.rng.randint(0, 1), 1)
                self.write(f"y[{i}]")
                self.outside(saved)
        else:
            i, saved = self.inside("all bodies")
            f.block(f.rng.randint(0, 3), 1)
            self.write(f"y[{f.pick([i, f't->perm[{i}]'])}]")
            self.outside(saved)
        f.coordinates["y"] = 9.0
        self.outputs.append("y")

    def phase_chain(self):
        """z, each one from the one before"""
        f = self.f
        up = f.chance(0.6)
        first, i = ("0" if up else "t->n - 1"), f.counter()
        self.write(f"z[{first}]")
        saved = f.open(
            f"for ({i} = 1; {i} < t->n; ++{i})" if up else f"for ({i} = t->n - 2; {i} >= 0; --{i})"
        )
        f.counters[i] = "body"
        f.loops += 1
        f.scalars[f"z[{i} {'-' if up else '+'} 1]"] = 9.0
        f.block(f.rng.randint(0, 2), 1)
        self.write(f"z[{i}]")
        self.outside(saved)
        f.coordinates["z"] = 9.0
        self.outputs.append("z")

    def phase_tree(self):
        """Y from the root to the leaves, by rows"""
        f = self.f
        k = f.counter()
        saved = f.open(f"for ({k} = 0; {k} < 3; ++{k})")
        f.counters[k] = "three"
        f.loops += 1
        f.line(f"Y[t->n][{k}] = {f.tied(f.value(1, 2.0))};")
        self.outside(saved)
        i = f.counter()
        saved = f.open(f"for ({i} = t->n - 1; {i} >= 0; --{i})")
        f.counters[i] = "body"
        f.loops += 1
        f.vectors[f"Y[t->parent[{i}]]"] = 8.0
        f.block(f.rng.randint(0, 2), 1)
        forms = []
        for _ in range(2):
            helpers = [h for h in self.helpers if h.kind == "void"]
            arguments = None
            if helpers and f.chance(0.8):
                helper = f.pick(helpers)
                arguments = f.call_arguments(helper, f"Y[{i}]")
            forms.append(f"{helper.name}({', '.join(arguments)});" if arguments else None)
        if forms[0] and forms[1] and f.chance(0.5):
            f.line(f"if ({f.condition()})")
            f.line("  " + forms[0])
            f.line("else")
            f.line("  " + forms[1])
        elif forms[0]:
            f.line(forms[0])
        else:
            f.write_three(lambda k, v: f"Y[{i}][{k}] = {v};", 3.0, f.tied)
        if f.chance(0.3):
            f.add_three(f"Y[{i}]")
        self.outside(saved)
        f.tables["Y"] = 8.0
        self.outputs.append("Y")

    def phase_workspace(self):
        """local arrays that are indexed by bodies: numbers, or rows"""
        f = self.f
        i, saved = self.inside(f.pick(["all bodies", "row"]))
        rows = f.counters[i] == "row"
        f.block(f.rng.randint(0, 1), 1)
        if rows:
            f.arrays["G"] = "5][3"
            helpers = [h for h in self.helpers if h.kind == "void"]
            arguments = None
            if helpers and f.chance(0.5):
                helper = f.pick(helpers)
                arguments = f.call_arguments(helper, f"G[{i}]")
            if arguments:
                f.line(f"{helper.name}({', '.join(arguments)});")
            else:
                f.write_three(lambda k, v: f"G[{i}][{k}] = {v};", 3.0)
        else:
            f.arrays["g"] = 4
            f.line(f"g[{i}] = {f.value(bound=3.0).text};")
            if f.chance(0.3):
                f.line(f"g[{i}] += {f.value(bound=2.0).text};")
        self.outside(saved)
        if rows and f.chance(0.3):
            e, saved = self.inside("edge")
            f.add_three(f"G[t->to[{e}]]")
            self.outside(saved)
            f.tables["G"] = 20.0
        elif rows:
            f.tables["G"] = 8.0
        else:
            f.coordinates["g"] = 5.0

    def phase_edges(self):
        """V = .., sums over edges, then sums from the leaves to the root"""
        f = self.f
        i, saved = self.inside("row")
        whole = [h for h in self.helpers if h.kind == "whole"]
        if whole and f.chance(0.7):
            f.line(f"{f.pick(whole).name}(t, {i}, X, {f.tied(f.value(1, 2.0))}, V);")
            f.line(f"V[{i}][0] += {f.tied(f.value(0, 2.0))};")
        else:
            f.write_three(lambda k, v: f"V[{i}][{k}] = {v};", 2.0, f.tied)
        self.outside(saved)
        if f.chance(0.8):
            e, saved = self.inside("edge")
            f.block(f.rng.randint(0, 2), 1)
            f.add_three(f"V[t->from[{e}]]")
            if f.chance(0.6):
                f.add_three(f"V[t->to[{e}]]")
            self.outside(saved)
        if f.chance(0.5):
            i = f.counter()
            saved = f.open(f"for ({i} = 0; {i} < t->n; ++{i})")
            f.counters[i] = "body"
            f.loops += 1
            k, inner = self.inside("all three")
            f.line(f"V[t->parent[{i}]][{k}] += V[{i}][{k}];")
            self.outside(inner)
            self.outside(saved)
        f.tables["V"] = 60.0
        self.outputs.append("V")

    def phase_energy(self):
        """e, a sum"""
        f = self.f
        f.line(f"e[0] = {f.pick(['0.0', f.value(2, 2.0).text])};")
        name, saved = self.inside(f.pick(["all bodies", "edge", "row"]))
        f.block(f.rng.randint(0, 2), 1)
        f.line(f"e[0] {f.pick(['+=', '-='])} {f.tied(f.value(bound=4.0))};")
        self.outside(saved)
        if f.chance(0.3):
            f.line(f"if ({f.condition()}) e[0] += {f.value(2, 2.0).text};")
        self.outputs.append("e")

    def phase_add(self):
        """F, which is added to and never read"""
        f = self.f
        e, saved = self.inside("edge")
        f.block(f.rng.randint(0, 2), 1)
        f.add_three(f"F[t->from[{e}]]")
        f.line(f"F[t->to[{e}]][{f.rng.randrange(3)}] -= {f.tied(f.value(2, 1.0))};")
        self.outside(saved)
        self.outputs.append("F")
