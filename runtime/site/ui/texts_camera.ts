// The words about the visitor's camera.

export const cameraTexts = {
  region: 'Camera',
  asks: 'A program of this page wants to use the camera of your device. Its pictures stay in this page.',
  opening: 'The browser asks whether this page may use the camera.',
  runs: 'A program uses the camera of your device.',
  use: 'Use camera',
  refuse: 'Refuse',
  stop: 'Stop the camera',
  // To the program's console.
  refused: 'the visitor refused',
  notAllowed: 'the browser does not allow it',
  noCamera: 'this device has no such camera',
  insecure: 'browsers give cameras to pages with https only',
  ended: 'the camera has ended',
} as const;
