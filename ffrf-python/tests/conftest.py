"""What tests share: the examples of the repository."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def models() -> Path:
    """The folder of the models that the examples use."""
    return ROOT / "models"


@pytest.fixture(scope="session")
def scenes(models: Path) -> Path:
    """The folder of the scenes of the examples."""
    return models / "scenes"
