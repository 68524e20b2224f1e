"""Drives the program as its users do: exit codes, error texts, JSON, files.
usage: cli.py PROGRAM SCENARIOS_FOLDER [unittest options]"""

import sys
import unittest

from cost_cases import Cost, Order
from effect_cases import Ablate, PriceList
from file_cases import Files, Streams
from output_cases import Interruptions, Outputs
from recorded_cases import Recorded
from scene_cases import Profile, Runs, Scenes
from stress_cases import Stress
from usage_cases import Catalogue, Usage
from view_cases import View

__all__ = ["Ablate", "Catalogue", "Cost", "Files", "Interruptions", "Order", "Outputs", "PriceList", "Profile", "Recorded",
           "Runs", "Scenes", "Streams", "Stress", "Usage", "View"]

if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
