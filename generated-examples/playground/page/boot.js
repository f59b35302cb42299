// In the frame of the interactive page: waits for its script, which the page around it sends once, and runs it.
"use strict";
addEventListener("message", (event) => {
  if (event.source !== parent) return;
  const script = document.createElement("script");
  script.src = URL.createObjectURL(new Blob([event.data], { type: "text/javascript" }));
  document.body.append(script);
}, { once: true });
