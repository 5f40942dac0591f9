"""The code of docs/python.md runs as it stands there."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest


def test_the_code_of_the_page_runs(models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = (models.parent / "docs" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", page, flags=re.DOTALL | re.MULTILINE)
    assert len(blocks) == 4
    (tmp_path / "models").symlink_to(models, target_is_directory=True)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for block in blocks:
        exec(compile(block, "docs/python.md", "exec"), names)
    assert names["rest"]["t"].shape == (1,) and names["rest"]["t"][0] == names["motion"]["t"][-1]
    assert names["plan"].predicted_error < 1e-2
    assert names["outcome"].failure is None
    assert names["best"].configuration.modes == 2
    assert (tmp_path / "sweep" / "report.html").exists()
