"""Jupyter's server for the course: sliders answer 40 ms sooner, and nbgrader's part in the server is off. Everything
else, the token included, stays as it is.

`make course` and the class server put this folder in front of the places where Jupyter looks for its configuration
(JUPYTER_CONFIG_PATH). So JupyterLab also finds the folder labconfig beside this file. Its page_config.json switches off
what a learner should not meet: nbgrader's button, menu and side bar, and the pop-up that asks about news of Jupyter. It
also switches off the icon of the browser's tab that shows a busy kernel: JupyterLab fetches it anew from the server for
each move of a slider, while the picture waits.
With default_setting_overrides.json a double click on a text, such as the cheat sheet, shows it with its formulas.

Sliders: as Jupyter comes, the system holds back each small message to the browser until the one before is acknowledged
(Nagle's algorithm). Here every message leaves at once.
"""

from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection


class PromptConnection(ZMQChannelsWebsocketConnection):
    """The usual connection between kernel and browser, without waiting."""

    def connect(self):
        self.websocket_handler.set_nodelay(True)
        return super().connect()


c = get_config()  # noqa: F821 (Jupyter puts this function here)
c.ServerApp.kernel_websocket_connection_class = PromptConnection

# nbgrader comes with `make .venv/more`. Learners get none of it: its button says "Success!" for an unanswered lesson.
parts = ("formgrader", "validate_assignment", "assignment_list", "course_list")
c.ServerApp.jpserver_extensions = {f"nbgrader.server_extensions.{part}": False for part in parts}
