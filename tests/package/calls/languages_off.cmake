# robcogen_add_robot(TARGET hyl): LANGUAGES: 'OFF' is not one of cpp c matlab maxima javascript
robcogen_add_robot(TARGET hyl MODEL hyl.kindsl LANGUAGES OFF)
