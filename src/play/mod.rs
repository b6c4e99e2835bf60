//! The playground without a browser: scene, link, camera, messages, and the brains of page and
//! worker.
