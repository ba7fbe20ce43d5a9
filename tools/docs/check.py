"""What MkDocs does not look for in a site: links to folders, anchors that are not there, and files that a
page would load from the network."""
import html.parser
import pathlib
import re
import urllib.parse

LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href", "video": "src"}
FOREIGN = re.compile(r"^(https?:)?//")


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        self.anchors |= {a[key] for key in ("id", "name") if a.get(key)}
        if tag == "a" and a.get("href"):
            self.links.append(a["href"])
        if LOADS.get(tag) in a and a.get("rel") not in ("canonical", "next", "prev"):
            self.loads.append(a[LOADS[tag]])


def target(page, path):
    to = pathlib.Path(urllib.parse.urljoin(page.as_uri(), path)[len("file://"):])
    to = pathlib.Path(urllib.parse.unquote(str(to)))
    return to / "index.html" if to.is_dir() else to


def site(folder):
    """Lines that say what is wrong; none where all is well."""
    pages = {path: Page(path) for path in folder.rglob("*.html")}
    wrong = []
    for path, page in pages.items():
        where = path.relative_to(folder)
        wrong += [f"{where}: loads {load} from the network" for load in page.loads if FOREIGN.match(load or "")]
        if path.name == "404.html":  # its links are absolute
            continue
        for link in page.links + page.loads:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            to = target(path, parts.path) if parts.path else path
            if not to.is_file():
                wrong.append(f"{where}: {link} leads nowhere")
            elif parts.fragment and to in pages and urllib.parse.unquote(parts.fragment) not in pages[to].anchors:
                wrong.append(f"{where}: {link} has no such anchor")
    for style in folder.rglob("*.css"):
        text = style.read_text(encoding="utf-8")
        wrong += [f"{style.relative_to(folder)}: loads {url} from the network"
                  for url in re.findall(r"(?:@import|url\()\s*[\"']?((?:https?:)?//[^\"')]+)", text)]
    return wrong
