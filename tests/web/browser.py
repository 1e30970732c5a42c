"""Pages in Chromium without a display, served from a folder. For the tests of the page."""
import functools
import http.server
import threading

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

# What Chromium says by itself: sound waits for a click, and notes on its own drawing.
HARMLESS = ("AudioContext was not allowed", "GL Driver Message", "Automatic fallback to software WebGL")


class Handler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve(folder):
    """Serves a folder on a port of this machine; returns the address."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}"


def open_browser(width=1024, height=720, profile=None):
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--use-gl=angle",
                     "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--window-size={width},{height}"):
        options.add_argument(argument)
    if profile:
        options.add_argument(f"--user-data-dir={profile}")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def complaints(browser):
    """Returns the warnings and errors of the console since the last call."""
    return [entry["message"] for entry in browser.get_log("browser")
            if not any(words in entry["message"] for words in HARMLESS)]
