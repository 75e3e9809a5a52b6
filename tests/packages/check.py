"""What the packages of ./x package hold: python3 tests/packages/check.py FOLDER

The files of each package are those of contents/<package>.txt; the rules of Debian are lintian's.
"""

import hashlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DOCUMENTATION = "usr/share/doc/oncard-doc"
# What lists leave out: the page, which is there where it could be built, and the documentation.
NOT_LISTED = re.compile(rf"usr/share/oncard/page/|{DOCUMENTATION}/(.*/|.*\.md$)")
FOLDER = Path(sys.argv.pop(1)) if len(sys.argv) > 1 else ROOT / "build" / "packages"
ARCHIVE = FOLDER / "oncard-windows.zip"


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Package:
    """A package of Debian, unpacked."""

    def __init__(self, path):
        self.name = path.name.split("_")[0]
        self._scratch = tempfile.TemporaryDirectory()
        self.root = Path(self._scratch.name)
        output_of("dpkg-deb", "--raw-extract", str(path), str(self.root))

    def field(self, name):
        found = re.search(rf"^{name}: (.*)$", (self.root / "DEBIAN" / "control").read_text(), re.M)
        return found[1] if found else ""

    def files(self):
        """Paths from the root, in order; a link is shown with its target."""
        names = []
        for path in self.root.rglob("*"):
            name = path.relative_to(self.root).as_posix()
            if path.is_symlink():
                names.append(f"{name} -> {path.readlink()}")
            elif path.is_file() and not name.startswith("DEBIAN/"):
                names.append(name)
        return sorted(names)


# Its Python cannot be had everywhere.
OPTIONAL = {"python3-oncard"}
PACKAGES = {package.name: package for package in map(Package, sorted(FOLDER.glob("*.deb")))}


class Packages(unittest.TestCase):
    def test_there_is_one_for_each_list(self):
        lists = {path.stem for path in HERE.glob("contents/*.txt")}
        self.assertEqual(set(PACKAGES) | OPTIONAL, lists)

    def test_hold_the_files_of_their_lists(self):
        for name, package in PACKAGES.items():
            expected = (HERE / "contents" / f"{name}.txt").read_text().splitlines()
            files = [file for file in package.files() if not NOT_LISTED.match(file)]
            with self.subTest(package=name):
                self.assertEqual(files, expected)

    def test_run_scripts_only_for_what_python_compiles(self):
        for name, package in PACKAGES.items():
            with self.subTest(package=name):
                control = {path.name for path in (package.root / "DEBIAN").iterdir()}
                scripts = {"postinst", "prerm"} if name == "python3-oncard" else set()
                self.assertEqual(control & {"preinst", "postinst", "prerm", "postrm"}, scripts)

    def test_have_one_version_and_need_each_other_in_it(self):
        (version,) = {package.field("Version") for package in PACKAGES.values()}
        for name in ("oncard", "libgts-dev"):
            self.assertIn(f"libgts1 (= {version})", PACKAGES[name].field("Depends").split(", "))

    def test_name_the_packages_whose_libraries_they_need(self):
        for name in ("oncard", "libgts1"):
            packages = {each.split(" ")[0] for each in PACKAGES[name].field("Depends").split(", ")}
            with self.subTest(package=name):
                self.assertLessEqual({"libc6", "libstdc++6", "libfmt9", "libxxhash0"}, packages)

    def test_python_is_the_one_of_the_module(self):
        if "python3-oncard" not in PACKAGES:
            self.skipTest("there is no python3-oncard: its packages cannot be had here")
        package = PACKAGES["python3-oncard"]
        (minor,) = re.findall(r"_oncard\.cpython-3(\d+)-", "\n".join(package.files()))
        depends = package.field("Depends").split(", ")
        self.assertIn(f"python3 (>= 3.{minor})", depends)
        self.assertIn(f"python3 (<< 3.{int(minor) + 1})", depends)

    def test_descriptions_are_sentences_to_their_end(self):
        for name, package in PACKAGES.items():
            control = (package.root / "DEBIAN" / "control").read_text()
            with self.subTest(package=name):
                self.assertRegex(control, r"Description: .*\n( .*\n)* .*\.\n(?! )")

    def test_programs_name_no_folders_of_libraries(self):
        for package in PACKAGES.values():
            for name in package.files():
                path = package.root / name
                if " -> " in name or path.read_bytes()[:4] != b"\x7fELF":
                    continue
                with self.subTest(file=name):
                    self.assertNotRegex(output_of("readelf", "--dynamic", str(path)), r"R(UN)?PATH")

    def test_links_of_the_documentation_lead_somewhere(self):
        folder = PACKAGES["oncard-doc"].root / DOCUMENTATION
        pages = sorted(folder.rglob("*.md"))
        self.assertIn(folder / "README.md", pages)
        for page in pages:
            text = re.sub(r"```.*?```", "", page.read_text(), flags=re.S)
            for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text):
                if not target.startswith("http"):
                    with self.subTest(page=page.relative_to(folder).as_posix(), target=target):
                        self.assertTrue((page.parent / target).exists())

    def test_obey_the_rules_of_debian(self):
        run = subprocess.run(
            ["lintian", "--allow-root", "--fail-on", "error,warning", *sorted(FOLDER.glob("*.deb"))],
            capture_output=True,
            text=True,
        )
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_the_archive_for_windows_has_what_hosts_need_once(self):
        if not ARCHIVE.exists():
            self.skipTest("there is no oncard-windows.zip: ./x windows was not run")
        with zipfile.ZipFile(ARCHIVE) as archive:
            files = archive.namelist()
        for folder in ("x64", "x86", "x64-multi", "x86-multi"):
            for name in ("gts.dll", "gts.lib", "libgts.a"):
                self.assertIn(f"{folder}/{name}", files)
        for name in ("x64/oncard.exe", "include/gts.h", "include/GT400.h", "LICENSE"):
            self.assertIn(name, files)
        # Windows does not distinguish capital letters.
        self.assertEqual(len({file.lower() for file in files}), len(files))

    def test_have_the_sums_of_their_list(self):
        lines = [line.split() for line in (FOLDER / "SHA256SUMS").read_text().splitlines()]
        files = [path for path in sorted(FOLDER.iterdir()) if path.name != "SHA256SUMS"]
        sums = [[hashlib.sha256(path.read_bytes()).hexdigest(), path.name] for path in files]
        self.assertEqual(lines, sums)


if __name__ == "__main__":
    unittest.main()
