"""`python -m dhlab` is the `dhlab` command."""

import sys

from dhlab.cli import main

sys.exit(main())
