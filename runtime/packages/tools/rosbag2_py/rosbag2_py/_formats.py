"""What there is of forms of messages and of storages, and what is said of others."""
from __future__ import annotations

SQLITE = ("bags of the storage 'sqlite3' (.db3) are neither read nor written in a site: use the storage 'mcap', and "
          'convert bags that you have with `ros2 bag convert`')


def need_converter(name: str) -> None:
    """RuntimeError: there is nothing that converts to or from it."""
    if name != 'cdr':
        raise RuntimeError(f'Could not find converter for format {name}')


def refuse_sqlite(storage_id: str, uri: str = '') -> None:
    if storage_id == 'sqlite3' or (not storage_id and uri.endswith('.db3')):
        raise RuntimeError(SQLITE)
