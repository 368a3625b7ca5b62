"""What the pictures of the tools have in common: tables read by their columns, and one manner of figure."""

import csv
import sys


def read_table(path):
    """Rows of a CSV file, as dictionaries of texts."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def drawing():
    """Matplotlib's pyplot, which needs no screen; ends the tool with one line where it is not there."""
    try:
        import matplotlib
    except ImportError:
        sys.exit(f"{sys.argv[0]}: a picture needs matplotlib (Debian: python3-matplotlib)")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    return pyplot


def new_figure(width, height):
    """A figure with one pair of axes. Inches."""
    return drawing().subplots(figsize=(width, height))


def finish(figure, axes, picture, legend_size):
    """Opening loads over something: the vertical axis, a grid and a legend, and the file."""
    axes.set_ylabel("$K_{op} / K_{max}$")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=legend_size)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)
