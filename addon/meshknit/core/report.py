"""The report of a run: meshknit-report-1."""

import sys


def build_report(library, model, settings, outcome):
    """Every key whose stage ran. Problems name vertices and faces of the user's mesh."""
    values = {stage: result.value for stage, result in outcome.results.items()}
    report = {
        "format": "meshknit-report-1",
        "ok": outcome.ok,
        "problems": outcome.problems,
    }
    if not outcome.ok:
        report["reason"] = outcome.message
    if "check" in values:
        knit, surface = values["check"], values["check"].surface
        report["mesh"] = {
            "vertices": len(model.vertices),
            "faces": len(model.faces),
            "boundaries": len(surface.boundaries),
            "genus": surface.genus,
            "components": surface.components,
            "area": surface.area,
            "scale": model.scale,
        }
        report["openings"] = [_opening(model, settings, rim) for rim in knit.rims]
    if "time" in values:
        check = values["time"][1]
        report["time_field"] = {
            "source": _source_name(model),
            "extrema": check["extrema"],
            "saddles": check["saddles"],
            "expected_saddles": check["expected_saddles"],
        }
    for stage in ("graph", "trace", "schedule"):
        if stage in values:
            report[stage] = values[stage].report
    if "graph" in values:
        report["seams"] = values["graph"].seams
    if "emit" in values:
        report["program"] = values["emit"].program
        report["check"] = values["emit"].check
    report["seconds"] = {stage: round(r.seconds, 4) for stage, r in outcome.results.items()}
    report["seconds"]["total"] = round(sum(report["seconds"].values()), 4)
    peak = peak_megabytes()
    if peak is not None:
        report["peak_mb"] = peak
    return report


def _source_name(model):
    if model.own_time is not None:
        return "attribute"
    return "constraints" if model.source is None else model.source.kind.lower()


def _opening(model, settings, rim):
    """What was cut: where (mm), its rim, and when that is knit (None: nothing says)."""
    entry = {"name": rim.name(model), "rim_length": rim.length, "time": rim.time(model)}
    entry["stitches"] = round(rim.length / settings.stitch_width)
    if rim.faces:
        return {**entry, "faces": list(rim.faces)}
    opening = model.openings[rim.opening]
    return {**entry, "at": list(opening.at), "radius": opening.radius}


def peak_megabytes():
    """The most memory this process had so far, where the system says so."""
    try:
        import resource
    except ImportError:  # Windows
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return round(peak / (1024 * 1024 if sys.platform == "darwin" else 1024), 1)


def summary_lines(report):
    """A few numbers for people, from a report: (name, value) pairs of the stages that ran."""
    lines = []
    if "graph" in report:
        graph = report["graph"]
        lines.append(("Rows", f"{graph['rows']} ({graph['short_rows']} short)"))
        lines.append(("Rows ±10 %", f"{graph['row_error']['within_10']:.1%}"))
        lines.append(("Cols. ±10 %", f"{graph['column_error']['within_10']:.1%}"))
        lines.append(("Irregular", f"{graph['irregular'] / graph['nodes']:.1%}"))
    if "trace" in report:
        lines.append(("Stitches", f"{report['trace']['stitches']}"))
    if "program" in report:
        program = report["program"]
        low, high = program["needles"]
        lines.append(("Passes", f"{program['passes']}"))
        lines.append(("Needles", f"{high - low + 1} ({low} to {high})"))
        lines.append(("Estimate", f"{program['estimated_minutes']:.0f} min"))
    if "check" in report:
        verdict = "passed" if report["check"]["ok"] else "failed"
        lines.append(("File check", verdict))
    return lines
