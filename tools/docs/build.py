#!/usr/bin/env python3
"""The documentation as a site: tools/docs/build.py BUILD makes BUILD/site.

The pages of the repository are laid out in BUILD/docs as they stand here, so that a link works in
both; beside them lie pages that the program prints (reference.py). MkDocs makes the site, strictly:
a broken link fails. check.py then looks for dead anchors and for what would be loaded from the network.
"""
import pathlib
import re
import shutil
import subprocess
import sys

import yaml

sys.dont_write_bytecode = True  # nothing is left beside the sources
import check
import reference

HOUSE = pathlib.Path(__file__).resolve().parents[2]
# What has pages, or is linked by one.
PARTS = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff", "LICENSE", "docs", "scenarios",
         "examples", "effects/effect.h", "materials/library", "tests/fuzz/readers", "tests/reference", "python", "base/page/format.md",
         "Containerfile", "debian/control"]
KINDS = {".md", ".h", ".png", ".svg", ".c", ".py", ".sh", ".cff", ".yaml", ".csv", ".txt", ".toml", ".ipynb"}


def lay_out(folder):
    shutil.rmtree(folder, ignore_errors=True)
    for part in PARTS:
        top = HOUSE / part
        for file in [top] if top.is_file() else sorted(top.rglob("*")):
            if file.is_file() and (top.is_file() or file.suffix in KINDS):
                to = folder / file.relative_to(HOUSE)
                to.parent.mkdir(parents=True, exist_ok=True)
                if file.suffix == ".md":
                    to.write_text(for_mkdocs(file.read_text(encoding="utf-8")), encoding="utf-8")
                else:
                    shutil.copyfile(file, to)


def for_mkdocs(text):
    """Python's Markdown wants an empty line before a list, a table and a fence, and four spaces for
    what belongs to an item of a list; elsewhere neither is needed."""
    lines, fenced = [], False
    for line in text.split("\n"):
        before = lines[-1] if lines else ""
        starts = re.match(r"(- |\d+\. |\||```)", line)
        if starts and not fenced and before.strip() and not before.startswith(("- ", "  ", "|", "#")):
            if not (starts.group(1)[0].isdigit() and re.match(r"\d+\. ", before)):
                lines.append("")
        fenced ^= line.startswith("```")
        lines.append(line)
    return "\n".join(lines)


def title(page):
    for line in page.read_text(encoding="utf-8").split("\n"):
        if line.startswith("# "):
            return re.sub(r"[`*]", "", line[2:].strip())
    raise SystemExit(f"{page}: no title")


def pages(folder, pattern):
    return [{title(page): str(page.relative_to(folder))} for page in sorted(folder.glob(pattern))]


def navigation(entry, lists, folder):
    """The navigation of mkdocs.yml with its lists put in, and without pages that are not there yet."""
    if isinstance(entry, list):
        out = []
        for item in entry:
            if isinstance(item, str) and item.startswith("@"):
                out += lists[item[1:]]
            else:
                kept = navigation(item, lists, folder)
                out += [] if kept is None else [kept]
        return out
    if isinstance(entry, dict):
        (name, value), = entry.items()
        if isinstance(value, str) and value.startswith("@"):
            return {name: lists[value[1:]]}
        kept = navigation(value, lists, folder)
        return None if kept is None else {name: kept}
    if entry.endswith("?"):
        return entry[:-1] if (folder / entry[:-1]).is_file() else None
    return entry


def main():
    if len(sys.argv) != 2:
        raise SystemExit("usage: tools/docs/build.py BUILD, the folder of a build that has the program")
    build = pathlib.Path(sys.argv[1]).resolve()
    folder, site = build / "docs", build / "site"
    lay_out(folder)
    shutil.copyfile(HOUSE / "tools/docs/site.css", folder / "site.css")
    lists = reference.everything(build / "umbra", HOUSE / "library/umbra.h", folder)
    lists["scenarios"] = pages(folder, "scenarios/*/README.md")
    lists["decisions"] = pages(folder, "docs/decisions/0*.md")
    settings = yaml.safe_load((HOUSE / "mkdocs.yml").read_text(encoding="utf-8"))
    settings["nav"] = navigation(settings["nav"], lists, folder)
    settings.update(docs_dir=str(folder), site_dir=str(site))
    made = build / "mkdocs.yml"
    made.write_text(yaml.safe_dump(settings, sort_keys=False), encoding="utf-8")
    shutil.rmtree(site, ignore_errors=True)
    done = subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "-f", made], capture_output=True, text=True)
    said = done.stdout + done.stderr
    wrong = [line for line in said.splitlines() if not line.startswith(("INFO", "  - "))] if done.returncode != 0 else check.site(site)
    if wrong:
        raise SystemExit("\n".join(wrong))
    print(f"{len(list(site.rglob('*.html')))} pages: {site}/index.html")


if __name__ == "__main__":
    main()
