"""What the tests of the package share."""

import pytest

import oncard


@pytest.fixture(autouse=True)
def english():
    oncard.set_language("en")
