#pragma once

#include <algorithm>
#include <cstdlib>

#include <QImage>
#include <QString>

/// How far two pictures of the same size are apart.
struct ImageDifference {
  double mean = 0;        ///< over all channels of all pixels, 0 to 255
  double shareApart = 0;  ///< of the pixels with a channel more than 40 apart, 0 to 1

  QString inWords() const {
    return QStringLiteral("mean %1, share apart %2").arg(mean).arg(shareApart);
  }
};

inline ImageDifference differenceOf(const QImage& a, const QImage& b) {
  ImageDifference difference;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int red = std::abs(qRed(p) - qRed(q));
      const int green = std::abs(qGreen(p) - qGreen(q));
      const int blue = std::abs(qBlue(p) - qBlue(q));
      difference.mean += (red + green + blue) / 3.0;
      difference.shareApart += std::max({red, green, blue}) > 40 ? 1 : 0;
    }
  const double count = static_cast<double>(a.width()) * a.height();
  difference.mean /= count;
  difference.shareApart /= count;
  return difference;
}

/// Share of the pixels with just this color, 0 to 1.
inline double shareOf(QRgb color, const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == color ? 1 : 0;
  return count / (static_cast<double>(image.width()) * image.height());
}
