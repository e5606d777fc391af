PAGE = "{runs}"
