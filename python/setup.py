"""The wheel of the package as CMake has built it: the module is already there."""

from setuptools import Distribution, setup


class BuiltDistribution(Distribution):
    """With a module, so that the wheel is for this Python on this kind of computer only."""

    def has_ext_modules(self) -> bool:
        return True


setup(distclass=BuiltDistribution)
