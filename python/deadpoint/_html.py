"""Summaries for notebooks: figures and charts as HTML without any script."""
from __future__ import annotations

import html
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from deadpoint._results import Result, Study
    from deadpoint._series import Series

_COLOURS = ("#1f5fa8", "#c8501e", "#2b8a5c", "#8a4fa3", "#a07d00", "#4a4a4a")
_WIDTH, _HEIGHT, _MARGIN = 420, 220, 46


def _ticks(low: float, high: float) -> list[float]:
    """Three to seven round numbers in a range."""
    step = 10.0 ** np.floor(np.log10((high - low) / 3))
    for factor in (5.0, 2.0):
        if (high - low) / (step * factor) >= 3:
            step *= factor
            break
    return [float(value) for value in np.arange(np.ceil(low / step), np.floor(high / step) + 1) * step]


def chart(series: Sequence[Series], title: str) -> str:
    """Lines over the hours, with a legend below."""
    series = [one for one in series if np.isfinite(one.values).any()]
    if not series:
        return ""
    low = min(float(np.nanmin(one.values)) for one in series)
    high = max(float(np.nanmax(one.values)) for one in series)
    if not high > low:
        low, high = low - 0.5, high + 0.5
    end = max(float(series[0].hours[-1]), 1e-9)
    wide, tall = _WIDTH - _MARGIN - 10, _HEIGHT - _MARGIN - 24

    def x(hour: float) -> float:
        return _MARGIN + wide * hour / end

    def y(value: float) -> float:
        return 24 + tall * (high - value) / (high - low)

    parts = [f'<svg width="{_WIDTH}" height="{_HEIGHT}" font-family="sans-serif" font-size="11" role="img">',
             f'<text x="{_MARGIN}" y="14" font-weight="bold">{html.escape(title)} [{html.escape(series[0].unit)}]</text>']
    for tick in _ticks(low, high):
        parts.append(f'<line x1="{_MARGIN}" x2="{_MARGIN + wide}" y1="{y(tick):.1f}" y2="{y(tick):.1f}" stroke="#ddd"/>'
                     f'<text x="{_MARGIN - 4}" y="{y(tick) + 4:.1f}" text-anchor="end">{tick:.6g}</text>')
    for tick in _ticks(0.0, end):
        parts.append(f'<text x="{x(tick):.1f}" y="{24 + tall + 14}" text-anchor="middle">{tick:g} h</text>')
    for one, colour in zip(series, _COLOURS):
        points = " ".join(f"{x(hour):.1f},{y(value):.1f}" for hour, value in zip(one.hours, one.values))
        parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
    place = float(_MARGIN)
    for one, colour in zip(series, _COLOURS):
        parts.append(f'<text x="{place:.0f}" y="{_HEIGHT - 6}" fill="{colour}">{html.escape(one.name)}</text>')
        place += 12 + 6.2 * len(one.name)
    return "".join([*parts, "</svg>"])


def _row(name: str, value: str) -> str:
    return f"<tr><th style='text-align:left'>{html.escape(name)}</th><td style='text-align:left'>{html.escape(value)}</td></tr>"


def result_html(result: Result) -> str:
    """Summary of a result with charts of the gap and the probes."""
    rows = [_row("case", f"{result.name}, hash {result.case_hash}"), _row("time", f"{result.time[-1] / 3600:.2f} h")]
    if result.dimensions:
        rows += [_row("E_SW at the end", f"{result.gap.end:+.2f} um"), _row("E_SW, largest", f"{result.gap.largest:+.2f} um")]
    if result.error:
        rows.append(_row("error of the reduced run", f"{result.error.temperature:.2g} K, {result.error.gap:.2g} um"))
    rows += [_row("outside the model's range", text) for text in result.outside]
    rows += [_row("warning", text) for text in result.warnings if not text.startswith("outside the range")]
    charts = [chart(list(result.dimensions.values()), "dimension chain")] if result.dimensions else []
    if result.probes:
        charts.append(chart(list(result.probes.values())[: len(_COLOURS)], "probes"))
    return f"<table>{''.join(rows)}</table><div>{''.join(charts)}</div>"


def study_html(study: Study) -> str:
    """What a folder of a study holds."""
    rows = [_row(name, f"{len(study.tables[name])} rows; {study.tables[name].meaning}") for name in study.tables]
    return f"<p>study in {html.escape(str(study.folder))}</p><table>{''.join(rows)}</table>"
