"""Imports every module of the package in the given folder, and prints the names of its operations."""

import importlib
import pkgutil
import sys
from pathlib import Path

folder = Path(sys.argv[1])
sys.path.insert(0, str(folder.parent))
package = importlib.import_module(folder.name)
for module in pkgutil.walk_packages(package.__path__, folder.name + "."):
    imported = importlib.import_module(module.name)
    if ".api." in module.name and not module.ispkg:
        print(module.name.rpartition(".")[2] if callable(imported.sync_detailed) else "")
