def write_page(found, here):
    return len(found)
