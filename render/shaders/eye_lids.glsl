// Where the lids' margins lie over an eyeball: heights over its centre, in radii, at nine places from x = -1.2 to 1.2 radii
// of the upper one, then of the lower one.
uniform highp float lid[18];

float LidHeight(int first, float x) {
  float at = clamp((x + 1.2) / 2.4, 0.0, 0.999) * 8.0;
  int i = int(at);
  return mix(lid[first + i], lid[first + i + 1], at - float(i));
}
float UpperLid(float x) { return LidHeight(0, x); }
float LowerLid(float x) { return LidHeight(9, x); }
