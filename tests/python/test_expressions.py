"""Expressions are the texts of conditions, with the parentheses that they need."""

import pytest

import oncard
from oncard import var

A, B = var("a"), var("b[2]")


@pytest.mark.parametrize(
    "expression, text",
    [
        (var("axis1.prfPos"), "axis1.prfPos"),
        (var("s.member[3].x"), "s.member[3].x"),
        (A < 100, "a < 100"),
        (A <= 1.5, "a <= 1.5"),
        (A > -1, "a > -1"),
        (3 >= A, "a <= 3"),
        (A == B, "a == b[2]"),
        (A != True, "a != 1"),
        (A + B * 2 - 1, "(a + (b[2] * 2)) - 1"),
        (1 - A, "1 - a"),
        (-A < 1e-9, "(-a) < 1e-09"),
        ((A < 1) & (B > 2) | ~(A == 3), "((a < 1) && (b[2] > 2)) || (!(a == 3))"),
        (A.near(5625, 1e-6), "a == 5625 +- 1e-06"),
        ((A + B).near(B, 1), "(a + b[2]) == b[2] +- 1"),
        ((A == 1).at(12.5), "a == 1 @ 12.5ms"),
    ],
)
def test_is_the_text_of_a_condition(expression, text):
    assert str(expression) == text


def test_means_what_python_means():
    files = {"p.c": "int a;\nint b;\nint main()\n{\n  a = 3;\n  b = -4;\n}\n"}
    a, b = var("a"), var("b")
    true = [a - b == 7, a + b * 2 == -5, ~(a < b) & (a > 0), (a < b) | (b < 0), -(a + b) == 1]
    run = oncard.run({"program": "p.c", "expect": true}, files=files)
    assert run.failures == []
    false = [~condition for condition in true]
    run = oncard.run({"program": "p.c", "expect": false}, files=files)
    assert [failure.expectation for failure in run.failures] == [str(each) for each in false]


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: A < 1 < B, "write &, |, ~"),
        (lambda: (A < 1) and (B < 1), "write &, |, ~"),
        (lambda: A < "b", r"write oncard.var\(\'sum\'\) for the name of a value"),
        (lambda: A < float("inf"), "finite numbers"),
        (lambda: var("a < 1"), "'a < 1' is no name of a value"),
        (lambda: var(3), "3 is no name of a value"),
    ],
)
def test_refuses_what_has_no_text(make, message):
    with pytest.raises(oncard.Error, match=message):
        make()
