"""A window under Xvfb, with the mouse and keyboard of xdotool."""
import os
import shutil
import subprocess
import time


def need(*tools):
    """Ends the test as skipped if a tool is missing."""
    for tool in tools:
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            raise SystemExit(77)


def wait_for(what, condition, seconds=60):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise SystemExit(f"waited {seconds} s in vain for {what}")


def start_display(*options, size="1280x720"):
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", size + "x24", "-nolisten", "tcp", *options]
    server = subprocess.Popen(command, pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    number = os.read(read, 16).decode().strip()
    if not number:
        raise SystemExit("Xvfb did not start")
    return server, ":" + number


def environment(display, **more):
    env = {name: value for name, value in os.environ.items() if name != "WAYLAND_DISPLAY"}
    return {**env, "DISPLAY": display, **more}


class Window:
    """The program in a window, with fresh settings in the emptied `folder`, recording what is done."""

    def __init__(self, coaster, folder, *options, files=None, size="1280x720"):
        """`files`: names and texts of files in the folder."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name, text in (files or {}).items():
            (folder / name).write_text(text)
        self.recording, self.log = folder / "recording.coaster", folder / "log.txt"
        self.screen = folder / "Xvfb_screen0"  # what the screen shows, in memory
        self.server, display = start_display("-fbdir", str(folder), size=size)
        self.environment = environment(display)
        self.environment.pop("GALLIVM_PERF", None)  # large pictures, and many: shaders are better compiled well
        command = [coaster, *options, "--record", self.recording, "--size", size, "--config", folder / "config"]
        self.program = subprocess.Popen(command, env=self.environment, stdout=self.log.open("w"),
                                        stderr=subprocess.STDOUT)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.program.kill()
        self.server.terminate()

    def xdo(self, *arguments):
        command = ["xdotool", *map(str, arguments)]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True).stdout

    def recorded(self):
        return self.recording.read_text() if self.recording.exists() else ""
