"""Tables of a run: CSV files with one line of column names."""
from __future__ import annotations

import collections.abc
import csv
import io
import os
import pathlib
import typing

import numpy as np

from .errors import ResultsError


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


class Table(collections.abc.Mapping[str, np.ndarray]):
    """
    Columns by name, as numpy arrays of one length: float where the file has
    numbers (nan where a cell is empty), else str.

        table = Table.read("results/statistics.csv")
        table["newton_iterations"].sum()
        table.pandas()
    """

    def __init__(self, texts: typing.Mapping[str, typing.Sequence[str]], path: str | os.PathLike[str] = ""):
        self.path = pathlib.Path(path)
        self._texts = {name: list(column) for name, column in texts.items()}
        self._arrays: dict[str, np.ndarray] = {}

    @classmethod
    def read(cls, path: str | os.PathLike[str], only_whole_rows: bool = False) -> Table:
        """
        Lines that begin with # are comments. `only_whole_rows`: leaves out a last
        row that is not written to its end, as that of a run that goes on.
        """
        with open(path, newline="", errors="replace") as file:
            text = file.read()
        if only_whole_rows:
            text = text[: text.rfind("\n") + 1]
        rows = list(csv.reader(line for line in io.StringIO(text, newline="") if not line.startswith("#") and line.strip()))
        header = [name.strip() for name in rows[0]] if rows else []
        if only_whole_rows:
            rows = [row for row in rows if len(row) == len(header)]
        return cls({name: [row[i].strip() if i < len(row) else "" for row in rows[1:]] for i, name in enumerate(header)}, path)

    # ------------------------------------------------------------- as a mapping
    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._texts:
            there = f"there are: {', '.join(self._texts)}" if self._texts else "it is empty or not there"
            raise KeyError(f"{self.path.name or 'the table'} has no column '{name}'; {there}")
        if name not in self._arrays:
            self._arrays[name] = self._converted(self._texts[name])
        return self._arrays[name]

    def __iter__(self) -> typing.Iterator[str]:
        return iter(self._texts)

    def __len__(self) -> int:
        """Number of columns; 0 of a table that is not there."""
        return len(self._texts)

    def __contains__(self, name: object) -> bool:
        return name in self._texts

    def __repr__(self) -> str:
        return f"Table({str(self.path)!r}: {self.n_rows} rows, columns {', '.join(self._texts)})"

    @staticmethod
    def _converted(texts: list[str]) -> np.ndarray:
        if not any(texts):
            return np.array(texts, dtype=float if not texts else str)
        try:
            return np.array([float(text) if text else np.nan for text in texts])
        except ValueError:
            return np.array(texts, dtype=str)

    # ------------------------------------------------------------------ access
    @property
    def n_rows(self) -> int:
        return len(next(iter(self._texts.values()), []))

    def last(self, name: str) -> typing.Any:
        """Of the last row; ResultsError without rows."""
        column = self[name]
        if len(column) == 0:
            raise ResultsError(f"{self.path} has no rows.")
        return column[-1]

    def total(self, name: str) -> float:
        """Sum over the rows; 0 without the column. Cells without a number do not count."""
        if name not in self:
            return 0.0
        column = self[name]
        return float(np.nansum(column)) if column.dtype.kind == "f" else 0.0

    def lists(self) -> dict[str, list[float | str]]:
        """Columns as lists, each cell a number where it is one."""
        return {name: [_number(text) for text in column] for name, column in self._texts.items()}

    def pandas(self) -> typing.Any:
        """A pandas.DataFrame; ResultsError without pandas."""
        try:
            import pandas
        except ImportError as error:
            raise ResultsError("Table.pandas() needs pandas. On Debian: apt-get install python3-pandas") from error
        return pandas.DataFrame(dict(self))
