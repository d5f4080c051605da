# robcogen_add_transforms(TARGET hyl): MOTIONS must be a .motdsl document, not '.kindsl': hyl.kindsl
robcogen_add_transforms(TARGET hyl MOTIONS hyl.kindsl)
