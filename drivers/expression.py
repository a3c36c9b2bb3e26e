"""Scale expressions of a profile: numbers, names of [params], + - * / ** and parentheses."""

import ast
import math
import operator
from collections.abc import Callable, Mapping
from difflib import get_close_matches


def _divide(left: float, right: float) -> float:
    return left / right


def _power(left: float, right: float) -> float:
    try:
        return math.pow(left, right)
    except ValueError as error:
        raise ArithmeticError from error


_BINARY: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: _divide,
    ast.Pow: _power,
}
_UNARY: dict[type[ast.unaryop], Callable[[float], float]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}
_LONGEST = 200


def _value(node: ast.expr, params: Mapping[str, float]) -> float:
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return float(number)
        case ast.Name(id=name):
            if name not in params:
                close = get_close_matches(name, params, n=1)
                hint = f'; did you mean "{close[0]}"?' if close else ""
                raise ValueError(f'"{name}" is not in [params]{hint}')
            return params[name]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
            return _BINARY[type(op)](_value(left, params), _value(right, params))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _UNARY:
            return _UNARY[type(op)](_value(operand, params))
        case _:
            raise ValueError("only numbers, names of [params], + - * / ** and () are allowed")


def evaluate(text: str, params: Mapping[str, float]) -> float:
    """Return the value of `text`.

    Raises
    ------
    ValueError
        The text is no such expression, names an unknown parameter, or has no finite value.
    """
    if len(text) > _LONGEST:
        raise ValueError(f"an expression has at most {_LONGEST} characters")
    try:
        result = _value(ast.parse(text.strip(), mode="eval").body, params)
    except SyntaxError as error:
        raise ValueError(f'"{text}" is no expression: {error.msg}') from error
    except (ArithmeticError, RecursionError, MemoryError) as error:
        raise ValueError(f'"{text}" has no finite value') from error
    if not math.isfinite(result):
        raise ValueError(f'"{text}" has no finite value')
    return result
