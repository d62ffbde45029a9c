"""Lets the tests import the generator and Debian's rosidl, whichever Python runs them."""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[4]
DEBIAN_PACKAGES = "/usr/lib/python3/dist-packages"
for _path in (str(ROOT / "runtime/packages/client/rosidl_typesupport_wasm_cpp/generator"), DEBIAN_PACKAGES):
    if _path not in sys.path:
        sys.path.append(_path)
