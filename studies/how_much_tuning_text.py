PAGE = "{of_hypotheses}\n{of_methods}\n{of_tasks}\n{of_settings}\n{tuning_maps}{beaten}"
