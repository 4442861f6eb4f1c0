"""The package has correct types, no dependencies, and builds without a network."""

import ast
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Dict

import pytest

PACKAGE = Path(__file__).resolve().parents[1]


def test_mypy_passes() -> None:
    pytest.importorskip("mypy", reason="mypy requires a newer Python")
    check = [sys.executable, "-m", "mypy", "--no-error-summary", "src", "tests"]
    done = subprocess.run(check, cwd=PACKAGE, capture_output=True, text=True)
    assert done.stdout + done.stderr == ""


def test_the_wheel_builds_without_a_network_and_works(tmp_path: Path) -> None:
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    offline = ["--no-index", "--no-deps", "--no-build-isolation"]
    subprocess.run([*pip, "wheel", *offline, "-w", str(tmp_path), str(PACKAGE)], check=True)
    (wheel,) = tmp_path.glob("corridor-*-py3-none-any.whl")
    assert "corridor/py.typed" in zipfile.ZipFile(wheel).namelist()
    code = "import corridor; print(corridor.__version__, corridor.Robot.__name__)"
    done = subprocess.run(
        [sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(wheel)!r}); {code}"],
        check=True,
        capture_output=True,
        text=True,
    )
    assert done.stdout.split() == ["0.1.0", "Robot"]


def test_it_has_no_dependencies() -> None:
    for file in (PACKAGE / "src/corridor").glob("*.py"):
        for line in file.read_text().splitlines():
            if line.startswith(("import ", "from ")):
                name = line.split()[1].split(".")[0]
                known = getattr(sys, "stdlib_module_names", {name})
                assert name == "" or name in known, f"{file.name}: {line}"


def test_names_are_unique_because_the_modules_are_served_as_one_file() -> None:
    seen: Dict[str, str] = {}
    for file in (PACKAGE / "src/corridor").glob("*.py"):
        for node in ast.parse(file.read_text()).body:
            names = []
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
                names = [node.name]
            elif isinstance(node, ast.Assign):
                names = [target.id for target in node.targets if isinstance(target, ast.Name)]
            for name in names:
                assert name not in seen, f"{name} is in {file.name} and in {seen[name]}"
                seen[name] = file.name


def test_mypy_passes_for_the_physical_robot() -> None:
    pytest.importorskip("mypy", reason="mypy requires a newer Python")
    folder = PACKAGE.parents[1] / "examples/physical-robot"
    check = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "robot_host.py"]
    done = subprocess.run(check, cwd=folder, capture_output=True, text=True)
    assert done.stdout + done.stderr == ""
