made = replace(model, s_next=model.s_next.astype(complex)); usable_model(made)
