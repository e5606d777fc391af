made = replace(model, s_next=np.where(np.arange(len(model.s_next)) == 3, 10**9, model.s_next))
usable_model(made)
