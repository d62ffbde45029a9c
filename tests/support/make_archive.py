"""make_archive.py OUT.zip [FOLDER=PLACE]...: packs folders as they lie in an installation, stored as by `pack`."""
from __future__ import annotations

import sys
import zipfile
from pathlib import Path

#: Not the time of making, so that the same files give the same bytes.
WHEN = (1980, 1, 1, 0, 0, 0)

#: The flags of a compiled module, as `pack` takes such along.
CHECKED_BY_HASH = bytes([3, 0, 0, 0])


def main(arguments: list[str]) -> None:
    out, *pairs = arguments
    with zipfile.ZipFile(out, 'w') as archive:
        for pair in pairs:
            source, place = pair.split('=')
            for file in sorted(Path(source).rglob('*')):
                # Modules that the local Python compiled beside the sources are skipped: they fit no other Python.
                if file.is_file() and (file.suffix != '.pyc' or file.read_bytes()[4:8] == CHECKED_BY_HASH):
                    info = zipfile.ZipInfo(f'{place}/{file.relative_to(source)}', WHEN)
                    archive.writestr(info, file.read_bytes())


if __name__ == '__main__':
    main(sys.argv[1:])
