/* uPlot takes the resolution of its canvases from here when it is loaded: at least 2, so that paper is sharp. Import this before uPlot. */
const own = devicePixelRatio;
if (own < 2) window.devicePixelRatio = 2;
