// The part of GraphicsMagick's interface for C++ that reads, makes, changes and writes pixels.
#pragma once

#include "Magick++/Color.h"
#include "Magick++/Exception.h"
#include "Magick++/Image.h"
