PAGE = ""
