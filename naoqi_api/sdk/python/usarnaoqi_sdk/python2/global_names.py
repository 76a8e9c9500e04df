"""`global NAME` behind a use of NAME: a warning in Python 2, an error in Python 3. The declaration
moves to where the function begins."""

import ast
import re
from typing import Any, List, Optional

PROBLEM = re.compile(r"name '(\w+)' is (?:used|assigned to) (?:prior to|before) global declaration")
MOST = 100  # declarations that are moved in one text


def moved(text: str) -> str:
    """The text with such declarations moved. Other errors are left for who compiles it."""
    for _ in range(MOST):
        try:
            compile(text, "text", "exec", dont_inherit=True)
            return text
        except SyntaxError as error:
            found = PROBLEM.match(error.msg or "")
            if not found or not error.lineno:
                return text
            text = _move(text, found.group(1), error.lineno)
    return text


def _move(text: str, name: str, line: int) -> str:
    tree = ast.parse(text)
    lines = text.split("\n")
    lines[line - 1] = re.sub(r"\bglobal\b([^;#]*)", lambda found: _without(found.group(1), name),
                             lines[line - 1], count=1)
    function = _functionAround(tree, line)
    if function:
        _declare(lines, function.body, name)
    return "\n".join(lines)


def _without(names: str, name: str) -> str:
    left = [one.strip() for one in names.split(",") if one.strip() != name]
    return "global " + ", ".join(left) if left else "pass"


def _functionAround(tree: Any, line: int) -> Optional[Any]:
    """The innermost one."""
    inside = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)
              and node.lineno <= line <= (node.end_lineno or line)]
    return max(inside, key=lambda node: node.lineno) if inside else None


def _declare(lines: List[str], body: List[Any], name: str) -> None:
    """In front of the first statement, on its line if it may share one."""
    first = body[0]
    indent = " " * first.col_offset
    rest = lines[first.lineno - 1][first.col_offset:]
    compound = isinstance(first, (ast.If, ast.For, ast.While, ast.Try, ast.With, ast.FunctionDef,
                                  ast.ClassDef))
    joint = "\n" + indent if compound else "; "
    lines[first.lineno - 1] = (lines[first.lineno - 1][:first.col_offset] + "global " + name +
                               joint + rest)
