// What kinds of media there are. The module puts a text in this one's place that names only those of the frame
// (media_kinds.h): code that is never run still costs software renderers registers and time.
#define MEDIA_CLOSED
#define MEDIA_BLOBS
#define MEDIA_HEIGHT
#define MEDIA_NOISE
#define MEDIA_GRIDS
#define MEDIA_RAMPS
#define MEDIA_PRODUCTS
#define MEDIA_ELLIPSOIDS
#define MEDIA_SHADOWS_MARCHED
#define MEDIA_SHADOWS_OPACITY
#define MEDIA_SHADOWS_FOURIER
#define MEDIA_SHADOWS_CLIPMAP
