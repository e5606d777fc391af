# The public face: what `import rlrobot_edu as rl` offers. Editors and mypy read it, and so does the lazy import.
# All else is imported from its module, as `from rlrobot_edu.learning.history import History`.
from .environments import make_env as make_env
from .experiments.compare import compare as compare
from .experiments.compare import repeat as repeat
from .experiments.comparison import Comparison as Comparison
from .learning.agent import Agent as Agent
from .learning.algorithm import Algorithm as Algorithm
from .learning.algorithm import Selection as Selection
from .learning.loop import evaluate as evaluate
from .learning.loop import learn as learn
from .learning.loop import steps as steps
from .learning.methods import Method as Method
from .models.read_recording import read_recording as read_recording
from .models.recording import Recording as Recording
from .models.recording import record as record
from .models.sample_model import SampleModel as SampleModel
from .models.value_iteration import value_iteration as value_iteration
from .robots.realism import Realism as Realism
from .show.curves import plot_learning as plot_learning
from .show.film import film as film
from .show.in3d.visualizer import meshcat as meshcat
from .show.top_down import plot_scene as plot_scene
from .task.task import Task as Task
from .task.task_file import load_task as load_task
from .task.variables import InputVariable as InputVariable
from .task.variables import OutputVariable as OutputVariable
from .widgets.playground.page import playground as playground
from .widgets.stage.page import stage as stage
from .widgets.stepper.widget import Stepper as Stepper
from .widgets.watching import watch as watch

__version__: str
