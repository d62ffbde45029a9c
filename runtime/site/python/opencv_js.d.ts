// npm's OpenCV.js has no types for its own script.

declare module '@opencvjs/web/lib/opencv_js.js' {
  /** Fills `options` with what OpenCV has. */
  export default function createOpenCv(options: object): Promise<unknown>;
}
